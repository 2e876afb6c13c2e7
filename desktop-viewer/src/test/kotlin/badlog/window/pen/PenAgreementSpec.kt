package badlog.window.pen

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points
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
import kotlin.math.sin

/** A pen's picture is that of the other one: what is seen on the screen is what is in the file. */
class PenAgreementSpec : FunSpec({
    val colors = PenColors.LIGHT
    val wave = Curve(Series(DoubleArray(200) { it.toDouble() }, DoubleArray(200) { if (it in 90..99) Double.NaN else sin(it / 9.0) }), holdsUntil = null)
        .apply { draw(0.0, 200.0, PixelColumns(200)) }
    val strokes = Strokes().apply { trace(wave, Scale(0.0, 200.0, 200.0), Scale(1.0, -1.0, 80.0, start = 10.0)) }

    fun Points.outline() = add(150.0, 20.0).add(180.0, 20.0).add(165.0, 50.0)

    val primitives: Map<String, Pen.() -> Unit> = mapOf(
        "lines" to { lines(strokes, colors.line(0), 1.5) },
        "dashed lines" to { lines(strokes, colors.line(1), 2.0, dash = 6.0) },
        "areas" to { areas(strokes, 50.0, faded(colors.line(2), 0.4)) },
        "segments" to { segments(Points().line(10.5, 0.0, 10.5, 100.0).line(0.0, 40.5, 200.0, 40.5), colors.line(3), 1.0) },
        "a chain" to { chain(Points().outline(), isClosed = true, colors.line(4), 3.0) },
        "shapes" to { shapes(Points().outline().add(10.0, 90.0).add(30.0, 90.0).add(20.0, 60.0), corners = 3, colors.line(5)) },
        "dots" to { dots(Points().add(50.0, 50.0).add(120.0, 20.0), 6.0, colors.line(6)) },
        "a ring" to { ring(100.0, 50.0, 20.0, colors.line(7), 3.0) },
        "a rectangle" to { rectangle(20.0, 30.0, 60.5, 25.0, faded(colors.line(8), 0.5)) },
        "what is moved and clipped" to { moved(30.0, 10.0) { clip(0.0, 0.0, 50.0, 40.0) { dots(Points().add(40.0, 30.0), 20.0, colors.line(9)) } } },
    )

    for ((name, draw) in primitives) {
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

private const val WIDTH = 200
private const val HEIGHT = 100
private const val WHITE = -1

/** Edges are smoothed a little differently. */
private const val TOLERANCE = 0.1
