package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Plane
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class PlaneSpec : FunSpec({
    val plane = Plane(Span(0.0, 16.0), Span(0.0, 8.0))

    test("a meter is as long along x as along y, and the whole requested part is visible") {
        for ((width, height) in listOf(400.0 to 400.0, 1000.0 to 100.0, 160.0 to 80.0)) {
            val fitted = plane.fitted(width, height)
            fitted.x.width / width shouldBe (fitted.y.width / height plusOrMinus 1e-9)
            (fitted.x.from <= 0 && fitted.x.to >= 16 && fitted.y.from <= 0 && fitted.y.to >= 8) shouldBe true
        }
    }

    test("zooming keeps the point below the pointer in place") {
        val zoomed = plane.scaled(0.5, 4.0, 2.0)
        zoomed shouldBe Plane(Span(2.0, 10.0), Span(1.0, 5.0))
        zoomed.xScale(100.0).placeOf(4.0) shouldBe plane.xScale(100.0).placeOf(4.0)
        zoomed.shifted(1.0, -1.0) shouldBe Plane(Span(3.0, 11.0), Span(0.0, 4.0))
    }

    test("a drag over the picture selects a part of the plane, from any corner") {
        val part = Plane(Span(4.0, 8.0), Span(4.0, 6.0))
        plane.part(0.25, 0.25, 0.5, 0.5) shouldBe part
        plane.part(0.5, 0.25, 0.25, 0.5) shouldBe part
    }

    test("a range below the precision of numbers, or beyond all numbers, cannot be drawn") {
        plane.isDrawable shouldBe true
        plane.scaled(1e-12, 4.0, 2.0).isDrawable shouldBe false
        plane.scaled(1e15, 4.0, 2.0).isDrawable shouldBe false
    }
})
