package badlog.viewer.export.figure

import org.apache.batik.transcoder.SVGAbstractTranscoder
import org.apache.batik.transcoder.TranscoderInput
import org.apache.batik.transcoder.TranscoderOutput
import org.apache.batik.transcoder.image.ImageTranscoder
import org.jetbrains.letsPlot.awt.plot.PlotSvgExport
import org.jetbrains.letsPlot.intern.toSpec
import java.awt.Color
import java.awt.image.BufferedImage
import java.io.IOException
import java.io.StringReader
import java.util.Locale

/** [figure] as a document of SVG in the sizes of [options], with a white margin around it. */
internal fun svgOf(figure: Figure, options: FigureOptions): String {
    val drawing = drawingOf(figure, options.copy(width = options.width - 2 * MARGIN)).toSpec()
    val svg = PlotSvgExport.buildSvgImageFromRawSpecs(drawing, useCssPixelatedImageRendering = false)
    return withMargin(PATH.replace(svg) { path -> LONG_NUMBER.replace(path.value, ::shortened) })
}

// A hundredth of a point is nothing to see, and the other digits are two thirds of the file.
private fun shortened(number: MatchResult) = "%.2f".format(Locale.ROOT, number.value.toDouble())

private fun withMargin(svg: String): String {
    val root = checkNotNull(ROOT.find(svg)) { "lets-plot begins its SVG in a new way." }
    val width = root.groupValues[2].toDouble() + 2 * MARGIN
    val height = root.groupValues[3].toDouble() + 2 * MARGIN
    val box = """width="$width" height="$height" viewBox="-$MARGIN -$MARGIN $width $height""""
    val tag = "<svg${root.groupValues[1]}$box${root.groupValues[4]}>"
    val paper = """<rect x="-$MARGIN" y="-$MARGIN" width="$width" height="$height" fill="white"/>"""
    return svg.replaceRange(root.range, tag + paper)
}

/**
 * The picture that [svg], of [width] points, describes, with [scale] pixels for each of them.
 *
 * @throws IOException with a sentence for the person, when it would be too large.
 */
internal fun imageOf(svg: String, width: Int, scale: Int): BufferedImage {
    val height = ROOT.find(svg)?.groupValues?.get(3)?.toDouble() ?: 0.0
    if (height * width * scale * scale > MAX_PIXELS) {
        throw IOException("The picture of so many graphs is too large; select fewer of them, or SVG.")
    }
    val rendering = Rendering()
    rendering.addTranscodingHint(SVGAbstractTranscoder.KEY_WIDTH, (width * scale).toFloat())
    rendering.addTranscodingHint(ImageTranscoder.KEY_BACKGROUND_COLOR, Color.WHITE)
    rendering.transcode(TranscoderInput(StringReader(svg)), null)
    return checkNotNull(rendering.image)
}

/** Keeps the image that Batik draws, instead of writing it. */
private class Rendering : ImageTranscoder() {
    var image: BufferedImage? = null

    override fun createImage(width: Int, height: Int) = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)

    override fun writeImage(image: BufferedImage, output: TranscoderOutput?) {
        this.image = image
    }
}

private const val MARGIN = 14
private const val MAX_PIXELS = 60_000_000
private val ROOT = Regex("""<svg([^>]*?)width="([\d.]+)" height="([\d.]+)"([^>]*)>""")
private val PATH = Regex(""" d="[^"]*"""")
private val LONG_NUMBER = Regex("""-?\d+\.\d{3,}(E-?\d+)?""")
