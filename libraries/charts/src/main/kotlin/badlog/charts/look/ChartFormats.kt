package badlog.charts.look

import org.apache.batik.transcoder.SVGAbstractTranscoder
import org.apache.batik.transcoder.TranscoderInput
import org.apache.batik.transcoder.TranscoderOutput
import org.apache.batik.transcoder.image.PNGTranscoder
import org.jetbrains.letsPlot.awt.plot.PlotSvgExport
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.toSpec
import java.io.ByteArrayOutputStream
import java.io.StringReader

/** Returns [plot] as a document of SVG that scales, and is called [title]. */
internal fun svgOf(plot: Plot, title: String): String {
    val drawn = PlotSvgExport.buildSvgImageFromRawSpecs(plot.toSpec())
    check(drawn.startsWith(BEGIN)) { "lets-plot’s SVG begins with ${drawn.take(BEGIN.length)}" }
    // Without a view box, only its paper would grow with its width.
    return "$BEGIN viewBox=\"0 0 ${Chart.WIDTH} ${Chart.HEIGHT}\" role=\"img\" aria-label=\"$title\"" + drawn.removePrefix(BEGIN)
}

/** Returns [svg] as a picture of [width] × [height] pixels, in PNG. */
internal fun pngOf(svg: String, width: Int, height: Int): ByteArray {
    val transcoder = PNGTranscoder()
    transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_WIDTH, width.toFloat())
    transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_HEIGHT, height.toFloat())
    // A chart has none of these; a text from a log must not become one either.
    transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_ALLOW_EXTERNAL_RESOURCES, false)
    transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_ALLOWED_SCRIPT_TYPES, "")
    transcoder.addTranscodingHint(SVGAbstractTranscoder.KEY_EXECUTE_ONLOAD, false)
    val out = ByteArrayOutputStream()
    transcoder.transcode(TranscoderInput(StringReader(svg)), TranscoderOutput(out))
    return out.toByteArray()
}

private const val BEGIN = "<svg"
