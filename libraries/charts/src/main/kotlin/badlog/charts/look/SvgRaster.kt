package badlog.charts.look

import org.apache.batik.gvt.renderer.ImageRenderer
import org.apache.batik.transcoder.SVGAbstractTranscoder
import org.apache.batik.transcoder.TranscoderInput
import org.apache.batik.transcoder.TranscoderOutput
import org.apache.batik.transcoder.image.PNGTranscoder
import java.awt.Font
import java.awt.RenderingHints
import java.awt.font.FontRenderContext
import java.io.ByteArrayOutputStream
import java.io.StringReader

/** Renders SVG as pictures, with Java's own fonts. */
object SvgRaster {
    private val screen = FontRenderContext(null, true, true)

    /** Returns [svg] as a picture of [width] × [height] pixels, in PNG. */
    fun png(svg: String, width: Int, height: Int): ByteArray {
        val transcoder = ExactTranscoder()
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_WIDTH, width.toFloat())
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_HEIGHT, height.toFloat())
        // Drawings have no scripts or external resources; a text from a log must not add one.
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_ALLOW_EXTERNAL_RESOURCES, false)
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_ALLOWED_SCRIPT_TYPES, "")
        transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_EXECUTE_ONLOAD, false)
        val out = ByteArrayOutputStream()
        transcoder.transcode(TranscoderInput(StringReader(svg)), TranscoderOutput(out))
        return out.toByteArray()
    }

    /** Returns the width, in pixels, of [text] in a picture, with a font size of [letters]. */
    fun widthOf(text: String, letters: Double, isBold: Boolean): Double =
        Font(Font.SANS_SERIF, if (isBold) Font.BOLD else Font.PLAIN, 1).deriveFont(letters.toFloat()).getStringBounds(text, screen).width
}

/** Draws lines at their exact positions: by default, Java moves them to the middle of a pixel. */
private class ExactTranscoder : PNGTranscoder() {
    override fun createRenderer(): ImageRenderer = super.createRenderer().apply {
        renderingHints[RenderingHints.KEY_STROKE_CONTROL] = RenderingHints.VALUE_STROKE_PURE
    }
}
