package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Plane
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class FieldJsonSpec : FunSpec({
    val text = """{"game":"A","field-image":"a.png","field-corners":{"top-left":[100,50],"bottom-right":[900,450]},"field-size":[50,25],"field-unit":"foot"}"""

    test("size, corners and picture are read, with the picture's place on the field") {
        val field = fieldOfJson(text)
        field.length shouldBe (15.24 plusOrMinus 1e-9)
        field.width shouldBe (7.62 plusOrMinus 1e-9)
        val plane = field.image!!.plane(field, 1000, 500)
        plane.x.from shouldBe (-1.905 plusOrMinus 1e-9)
        plane.x.to shouldBe (15.24 + 1.905 plusOrMinus 1e-9)
        plane.y.from shouldBe (-0.9525 plusOrMinus 1e-9)
        plane.y.to shouldBe (7.62 + 0.9525 plusOrMinus 1e-9)
        Plane(Span(0.0, 10.0), Span(0.0, 5.0)).boxOf(Plane(Span(-1.0, 9.0), Span(1.0, 6.0)), 100.0, 50.0).toList() shouldBe listOf(-10.0, -10.0, 100.0, 50.0)
    }

    test("a field with its embedded picture is read back the same") {
        val field = fieldOfJson(text)
        val again = fieldOfJson(fieldJson(field.withPicture("data:image/png;base64,AAAA")))
        again.length shouldBe (field.length plusOrMinus 1e-9)
        again.image!!.run { listOf(left, top, right, bottom) } shouldBe field.image!!.run { listOf(left, top, right, bottom) }
        again.image.source shouldBe "data:image/png;base64,AAAA"
    }

    test("a mistake is reported with the next step") {
        fun sentence(old: String, new: String) = shouldThrow<FieldException> { fieldOfJson(text.replace(old, new)) }.message
        sentence(text, "[1]") shouldBe "It is not a JSON object; select the field’s .json file."
        sentence("[100,50]", "[100]") shouldBe "“top-left” is not a pair of numbers; write it as [x, y]."
        sentence("[900,450]", "[90,450]") shouldBe "“bottom-right” is not below and to the right of “top-left”; swap them."
        sentence("foot", "furlong") shouldBe "“field-unit” is neither “foot” nor “meter”; write one of them."
        sentence("[50,25]", "[0,25]") shouldBe "“field-size” is not the size of a field; give its length and width, as [54, 27]."
        sentence("field-image", "picture") shouldBe "“field-image” is missing; name the picture beside the file."
    }
})
