package badlog.window.export.figure

import badlog.viewer.draw.figure.FigureNotes
import badlog.viewer.text.countText
import badlog.window.findings.findingColor
import badlog.window.theme.Palette
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

/** Returns [figure] as a document of SVG in the sizes of [options], with its notes below and a white margin around it. */
internal fun svgOf(figure: Figure, options: FigureOptions): String {
    val drawing = drawingOf(figure, options.copy(width = options.width - 2 * MARGIN)).toSpec()
    val svg = PlotSvgExport.buildSvgImageFromRawSpecs(drawing, useCssPixelatedImageRendering = false)
    return withMargin(PATH.replace(svg) { path -> LONG_NUMBER.replace(path.value, ::shortened) }, figure.notes)
}

// A hundredth of a point is invisible, and further digits would be two thirds of the file.
private fun shortened(number: MatchResult) = "%.2f".format(Locale.ROOT, number.value.toDouble())

private fun withMargin(svg: String, notes: FigureNotes?): String {
    val root = checkNotNull(ROOT.find(svg)) { "lets-plot begins its SVG in a new way." }
    val width = root.groupValues[2].toDouble() + 2 * MARGIN
    val drawn = root.groupValues[3].toDouble()
    val lines = notes?.let { noteLines(it, ((width - 2 * MARGIN) / LETTER).toInt()) }.orEmpty()
    val texts = lines.withIndex().joinToString("") { (i, line) -> "<g transform=\"translate(0, ${drawn + (i + 1) * LINE})\">$line</g>" }
    val height = drawn + lines.size * LINE + 2 * MARGIN
    val box = """width="$width" height="$height" viewBox="-$MARGIN -$MARGIN $width $height""""
    val tag = "<svg${root.groupValues[1]}$box${root.groupValues[4]}>"
    val paper = """<rect x="-$MARGIN" y="-$MARGIN" width="$width" height="$height" fill="white"/>"""
    return svg.replaceRange(root.range, tag + paper).replaceAfterLast("</svg>", "").removeSuffix("</svg>") + "$texts</svg>"
}

/** Returns what [notes] say, each line as an element of SVG of at most so many letters. */
private fun noteLines(notes: FigureNotes, letters: Int): List<String> {
    fun text(color: String, content: String) = "<text fill=\"$color\" font-family=\"sans-serif\" font-size=\"12\">$content</text>"
    val muted = hexOf(Palette.LIGHT.muted)
    val more = if (notes.moreFindings == 0) emptyList() else listOf("${countText(notes.moreFindings, "more finding")} in this range")
    return listOf(text(muted, escaped(plainLine(notes.place, letters)))) + notes.findings.map { finding ->
        val color = hexOf(Palette.LIGHT.findingColor(finding.severity))
        val found = escaped(plainLine(finding.text, letters - finding.head.length))
        text(muted, "<tspan fill=\"$color\" font-weight=\"bold\">${escaped(finding.head)}</tspan>  $found")
    } + more.map { text(muted, it) }
}

/**
 * Returns the picture of [svg], which is [width] points wide, with [scale] pixels per point.
 *
 * @throws IOException with a sentence for the user, if it would be too large.
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

/** Returns [text], which [plainLine] made, between tags. */
private fun escaped(text: String) = text.replace("&", "&amp;").replace("<", "&lt;")

private const val MARGIN = 14
private const val LINE = 17
private const val LETTER = 6.4
private const val MAX_PIXELS = 60_000_000
private val ROOT = Regex("""<svg([^>]*?)width="([\d.]+)" height="([\d.]+)"([^>]*)>""")
private val PATH = Regex(""" d="[^"]*"""")
private val LONG_NUMBER = Regex("""-?\d+\.\d{3,}(E-?\d+)?""")
