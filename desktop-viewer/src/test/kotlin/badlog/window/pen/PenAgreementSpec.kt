package badlog.window.pen

import badlog.charts.look.SvgRaster
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.PEN_PRIMITIVES
import badlog.viewer.draw.pen.PEN_TEXTS
import badlog.viewer.draw.pen.PRIMITIVE_HEIGHT
import badlog.viewer.draw.pen.PRIMITIVE_IMAGE
import badlog.viewer.draw.pen.PRIMITIVE_WIDTH
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.PenPicture
import badlog.viewer.draw.pen.SvgPen
import badlog.viewer.draw.pen.TEXT_TOLERANCE
import badlog.viewer.draw.pen.TextSide
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import org.jetbrains.skia.Bitmap
import org.jetbrains.skia.Image
import org.jetbrains.skia.Surface
import java.util.Base64
import kotlin.math.abs

/**
 * The window's pen and the SVG pen draw the same: a file shows the same as the screen. Pictures of charts, and an assistant's pictures, are
 * made of SVG as here.
 */
class PenAgreementSpec : FunSpec({
    val colors = PenColors.LIGHT
    val image = SkiaImage(Image.makeFromEncoded(Base64.getDecoder().decode(PRIMITIVE_IMAGE.substringAfter(','))), PRIMITIVE_IMAGE)
    for ((name, draw) in PEN_PRIMITIVES) {
        test("the window's pen and the file's pen draw $name alike") {
            val screen = onScreen { draw(it, image) }
            val file = inFile { draw(it, image) }
            val blank = onScreen { }
            screen.differenceFrom(blank) shouldBeGreaterThan 0.1
            screen.differenceFrom(file) shouldBeLessThan screen.differenceFrom(blank) * TOLERANCE
        }
    }

    for ((name, text) in PEN_TEXTS) {
        test("the window's pen and the file's pen write $name at its place, as wide as they measure") {
            val ruler = ruler()
            val pens = listOf(onScreen(text::writeWith) to ruler::widthOf, inFile(text::writeWith) to SvgRaster::widthOf)
            for ((drawn, widthOf) in pens) {
                val covered = drawn.covered().shouldNotBeNull()
                withClue("$covered for ${text.boxFor(widthOf)}") {
                    covered.distanceFrom(text.boxFor(widthOf)) shouldBeLessThan TEXT_TOLERANCE
                }
            }
            // The part that an outline does not cover.
            val dark = pens.map { (drawn, _) -> drawn.dark(most = 128) }
            dark.min() shouldBeGreaterThan dark.max() / 2
        }
    }

    test("a text is drawn between its ends, whether it is written letter by letter or shaped, like Arabic and separate accents") {
        for (text in listOf("-12.5 V", "Größe (µΩ) – Δ", "سلام", "e\u0301", "🤖")) {
            val screen = onScreen { pen ->
                pen.text(text, 20.0, 50.0, 16.0, colors.line(0), TextSide.RIGHT)
                pen.widthOf(text, 16.0) shouldBeGreaterThan 5.0
                pen.widthOf(text, 16.0) shouldBeLessThan 160.0
            }
            // The text covers no pixel before its beginning or beyond its end.
            val covered = screen.covered().shouldNotBeNull()
            covered.left shouldBeGreaterThan 16.9
            covered.right shouldBeLessThan 190.1
        }
    }

    test("letters that need no shaping are as wide as shaped ones") {
        val pen = ruler()

        // The last letter has to be shaped, and so the whole text is shaped.
        fun shaped(text: String) = pen.widthOf("$text\u0301", 16.0) - pen.widthOf("e\u0301", 16.0) + pen.widthOf("e", 16.0)
        for (text in listOf("12.5e", "0.001e", "-40e")) abs(shaped(text) - pen.widthOf(text, 16.0)) shouldBeLessThan 1.0
    }
})

private fun ruler() = Surface.makeRasterN32Premul(WIDTH, HEIGHT).use { SkiaPen(it.canvas, density = 1.0) }

private fun onScreen(draw: (Pen) -> Unit): PenPicture = picture { draw(SkiaPen(it.canvas, density = 1.0)) }

private fun inFile(draw: (Pen) -> Unit): PenPicture {
    val svg = SvgPen(SvgRaster::widthOf).apply(draw).document(WIDTH.toDouble(), HEIGHT.toDouble(), WHITE)
    return Image.makeFromEncoded(SvgRaster.png(svg, WIDTH, HEIGHT)).use { image -> picture { it.canvas.drawImage(image, 0f, 0f) } }
}

private fun picture(draw: (Surface) -> Unit): PenPicture = Surface.makeRasterN32Premul(WIDTH, HEIGHT).use { surface ->
    surface.canvas.clear(WHITE)
    draw(surface)
    val bitmap = Bitmap.makeFromImage(surface.makeImageSnapshot())
    PenPicture(IntArray(WIDTH * HEIGHT) { bitmap.getColor(it % WIDTH, it / WIDTH) })
}

private const val WIDTH = PRIMITIVE_WIDTH
private const val HEIGHT = PRIMITIVE_HEIGHT
private const val WHITE = -1

/** The difference between two ways of smoothing edges. */
private const val TOLERANCE = 0.1
