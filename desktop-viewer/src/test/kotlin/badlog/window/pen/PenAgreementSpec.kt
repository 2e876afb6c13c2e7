package badlog.window.pen

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.PEN_PRIMITIVES
import badlog.viewer.draw.pen.PRIMITIVE_HEIGHT
import badlog.viewer.draw.pen.PRIMITIVE_WIDTH
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.draw.pen.TextSide
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.Data
import org.jetbrains.skia.Surface
import org.jetbrains.skia.svg.SVGDOM
import kotlin.math.abs

/** The window's pen draws what the one of SVG does: what is seen on the screen is what is in the file. */
class PenAgreementSpec : FunSpec({
    val colors = PenColors.LIGHT
    for ((name, draw) in PEN_PRIMITIVES) {
        test("the window's pen and the file's draw $name alike") {
            val screen = pixels { surface -> SkiaPen(surface.canvas, density = 1.0).draw() }
            val svg = SvgPen({ _, _, _ -> 0.0 }).apply(draw).document(WIDTH.toDouble(), HEIGHT.toDouble(), WHITE)
            val file = pixels { surface -> SVGDOM(Data.makeFromBytes(svg.encodeToByteArray())).use { it.render(surface.canvas) } }
            val blank = pixels { }
            difference(screen, blank) shouldBeGreaterThan 0.1
            difference(screen, file) shouldBeLessThan difference(screen, blank) * TOLERANCE
        }
    }

    test("a text is drawn between its ends, whether it is written letter by letter or has to be shaped, as Arabic and accents that are letters of their own") {
        for (text in listOf("-12.5 V", "Größe (µΩ) – Δ", "سلام", "e\u0301", "🤖")) {
            val blank = pixels { }
            val screen = pixels { surface ->
                val pen = SkiaPen(surface.canvas, density = 1.0)
                pen.text(text, 20.0, 50.0, 16.0, colors.line(0), TextSide.RIGHT)
                pen.widthOf(text, 16.0) shouldBeGreaterThan 5.0
                pen.widthOf(text, 16.0) shouldBeLessThan 160.0
            }
            difference(screen, blank) shouldBeGreaterThan 0.05
            // Nothing before its beginning, nor beyond its end.
            for (y in 0 until HEIGHT) for (x in (0 until 17) + (190 until WIDTH)) screen.getColor(x, y) shouldBe WHITE
        }
    }

    test("letters that need no shaping are as wide as if they were shaped") {
        val pen = Surface.makeRasterN32Premul(WIDTH, HEIGHT).use { SkiaPen(it.canvas, density = 1.0) }

        // The last letter has to be shaped, so all of that text is.
        fun shaped(text: String) = pen.widthOf("$text\u0301", 16.0) - pen.widthOf("e\u0301", 16.0) + pen.widthOf("e", 16.0)
        for (text in listOf("12.5e", "0.001e", "-40e")) abs(shaped(text) - pen.widthOf(text, 16.0)) shouldBeLessThan 1.0
    }
})

private fun pixels(draw: (Surface) -> Unit): Bitmap = Surface.makeRasterN32Premul(WIDTH, HEIGHT).use { surface ->
    surface.canvas.clear(WHITE)
    draw(surface)
    Bitmap.makeFromImage(surface.makeImageSnapshot())
}

/** Returns the mean difference of a color's part, from 0 to 255. */
private fun difference(one: Bitmap, other: Bitmap): Double {
    var sum = 0L
    for (y in 0 until HEIGHT) {
        for (x in 0 until WIDTH) {
            for (shift in 0..16 step 8) sum += abs(((one.getColor(x, y) shr shift) and 0xFF) - ((other.getColor(x, y) shr shift) and 0xFF))
        }
    }
    return sum / (3.0 * WIDTH * HEIGHT)
}

private const val WIDTH = PRIMITIVE_WIDTH
private const val HEIGHT = PRIMITIVE_HEIGHT
private const val WHITE = -1

/** Edges are smoothed a little differently. */
private const val TOLERANCE = 0.1
