package badlog.viewer.draw.pen

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class SvgPenSpec : FunSpec({
    fun pen() = SvgPen({ text, letters, _ -> text.length * letters / 2 })

    fun drawn(draw: Pen.() -> Unit) = pen().apply(draw).document(10.0, 5.0, WHITE).substringAfter("z\"/>").substringBefore("</svg>")

    test("a document has its size, and a background") {
        pen().document(10.0, 5.5, WHITE) shouldBe "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10\" height=\"5.5\" viewBox=\"0 0 10 5.5\" " +
            "font-family=\"system-ui, sans-serif\"><path fill=\"#ffffff\" d=\"M0 0H10V5.5H0z\"/></svg>\n"
    }

    test("numbers have at most two decimals, the same on all platforms") {
        drawn { segments(Points().line(-0.004, 1.006, 1e5 / 3, -2.5), BLUE, 1.0) } shouldContain "d=\"M0 1.01L33333.33 -2.5\""
        drawn { rectangle(-0.05, 10.0, 0.1, 100.0, BLUE) } shouldContain "d=\"M-0.05 10h0.1v100h-0.1z\""
    }

    test("a translucent color has an opacity") {
        drawn { rectangle(0.0, 0.0, 1.0, 1.0, faded(BLUE, 0.5)) } shouldBe "<path d=\"M0 0h1v1h-1z\" fill=\"#0000ff\" fill-opacity=\"0.5\"/>"
    }

    test("a drawing inside a page can name the page's colors instead of its own") {
        val pen = SvgPen({ _, _, _ -> 0.0 }, cssOf = { if (it and 0xFFFFFF == 0x0000FF) "var(--line)" else "var(--paper)" })
        pen.segments(Points().line(0.0, 0.0, 1.0, 0.0), faded(BLUE, 0.5), 1.0)
        pen.text("A", 0.0, 0.0, 10.0, BLUE, halo = WHITE)
        val svg = pen.document(1.0, 1.0, WHITE)
        svg shouldContain "<path fill=\"var(--paper)\""
        svg shouldContain "stroke=\"var(--line)\" stroke-opacity=\"0.5\""
        svg shouldContain "stroke=\"var(--paper)\" stroke-width=\"3\""
        svg shouldContain "fill=\"var(--line)\">A<"
    }

    test("a title is shown under the pointer, whatever its characters") {
        val svg = SvgPen({ _, _, _ -> 0.0 }).apply { titled("a < b") { rectangle(0.0, 0.0, 1.0, 1.0, BLUE) } }.document(1.0, 1.0, WHITE)
        svg shouldContain "<g><title>a &lt; b</title><path d=\"M0 0h1v1h-1z\" fill=\"#0000ff\"/></g></svg>"
    }

    test("an empty drawing leaves no element") {
        drawn {
            segments(Points(), BLUE, 1.0)
            shapes(Points(), 3, BLUE)
            dots(Points(), 1.0, BLUE)
        } shouldBe ""
    }

    test("a move and a clip apply only to the drawing within them") {
        val svg = drawn {
            moved(10.0, 20.0) { clip(0.0, 0.0, 5.0, 5.0) { rectangle(1.0, 1.0, 1.0, 1.0, BLUE) } }
            rectangle(1.0, 1.0, 1.0, 1.0, BLUE)
        }
        svg shouldContain "<clipPath id=\"cut1\"><path d=\"M10 20h5v5h-5z\"/></clipPath><path d=\"M11 21h1v1h-1z\" fill=\"#0000ff\" clip-path=\"url(#cut1)\"/>"
        svg shouldContain "<path d=\"M1 1h1v1h-1z\" fill=\"#0000ff\"/>"
    }

    test("nested clips show their common part, also of texts, and nothing without one") {
        val svg = drawn {
            clip(0.0, 0.0, 8.0, 8.0) {
                moved(5.0, 2.0) { clip(0.0, 0.0, 10.0, 3.0) { text("A", 0.0, 0.0, 10.0, BLUE) } }
                clip(9.0, 9.0, 10.0, 10.0) { rectangle(0.0, 0.0, 20.0, 20.0, BLUE) }
                rectangle(1.0, 1.0, 1.0, 1.0, BLUE)
            }
        }
        svg shouldBe "<clipPath id=\"cut1\"><path d=\"M0 0h8v8h-8z\"/></clipPath>" +
            "<clipPath id=\"cut2\"><path d=\"M5 2h3v3h-3z\"/></clipPath>" +
            "<text x=\"5\" y=\"5.5\" font-size=\"10\" fill=\"#0000ff\" clip-path=\"url(#cut2)\">A</text>" +
            "<clipPath id=\"cut3\"><path d=\"M9 9h0v0h0z\"/></clipPath><path d=\"M0 0h20v20h-20z\" fill=\"#0000ff\" clip-path=\"url(#cut3)\"/>" +
            "<path d=\"M1 1h1v1h-1z\" fill=\"#0000ff\" clip-path=\"url(#cut1)\"/>"
    }

    test("an area begins with the first sample that is not isolated") {
        val curve = Curve(Series(doubleArrayOf(0.0, 1.0, 2.0, 3.0, 4.0), doubleArrayOf(1.0, Double.NaN, 1.0, 2.0, Double.NaN)), holdsUntil = null)
        curve.draw(0.0, 4.0, PixelColumns(4))
        drawn { areas(Strokes().apply { trace(curve, Scale.NONE, Scale.NONE) }, baseline = 5.0, BLUE) } shouldBe
            "<path d=\"M2 1L3 2L3 5L2 5z\" fill=\"#0000ff\"/>"
    }

    test("an outline is below its letters, and screen readers skip it") {
        drawn { text("A", 0.0, 0.0, 10.0, BLUE, halo = WHITE) } shouldBe
            "<text x=\"0\" y=\"3.5\" font-size=\"10\" aria-hidden=\"true\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"3\" " +
            "stroke-linejoin=\"round\">A</text><text x=\"0\" y=\"3.5\" font-size=\"10\" fill=\"#0000ff\">A</text>"
    }

    test("a text is beside its place, around the middle of its letters") {
        val svg = drawn { text("A", 5.0, 3.0, letters = 10.0, BLUE, TextSide.LEFT, isBold = true) }
        svg shouldBe "<text x=\"5\" y=\"6.5\" font-size=\"10\" text-anchor=\"end\" font-weight=\"bold\" fill=\"#0000ff\">A</text>"
    }

    test("no text can leave its element, or break the XML") {
        // As a literal, it would not survive an incremental compilation to JavaScript.
        val half = Char(0xD834)
        drawn { text("<a>&\"\u0001\uD834\uDD1E$half", 0.0, 0.0, 1.0, BLUE) } shouldContain ">&lt;a>&amp;&quot;\uFFFD\uD834\uDD1E\uFFFD<"
        checkAll(Arb.string(0..20)) { text ->
            val content = drawn { text(text, 0.0, 0.0, 1.0, BLUE) }.substringAfter("\">").substringBefore("</text>")
            content shouldNotContain "<"
            content.all { it >= ' ' && it < '\uFFFE' } shouldBe true
        }
    }

    test("a long text is cut at its end, or in its middle") {
        val pen = pen()
        pen.fittedStart("Elevator", 40.0, letters = 10.0) shouldBe "Elevator"
        pen.fittedStart("Elevator", 30.0, letters = 10.0) shouldBe "Eleva…"
        pen.fittedEnds("Elevator", 30.0, letters = 10.0) shouldBe "El…tor"
        pen.fittedEnds("Elevator", 0.0, letters = 10.0) shouldBe "…"
    }
})

private const val WHITE = 0xFFFFFF or (0xFF shl 24)
private const val BLUE = 0x0000FF or (0xFF shl 24)
