package badlog.charts.look

import org.jetbrains.letsPlot.intern.Plot

/**
 * A chart of many logs. It has a white background and needs nothing else: no script, no font, no network.
 *
 * @property name its name in names of files: lower-case letters and `-`.
 * @property title what it shows.
 * @property question the question of a team that it answers.
 * @property reading how to read it, as a sentence.
 */
class Chart private constructor(val name: String, val title: String, val question: String, val reading: String, private val plot: Plot) {
    internal constructor(texts: ChartTexts, reading: String, plot: Plot) : this(texts.name, texts.title, texts.question, reading, plot)

    private val svg by lazy { svgOf(plot, title) }

    /** Returns it as a document of SVG, [WIDTH] × [HEIGHT] points large. */
    fun svg(): String = svg

    /** Returns it as a picture in PNG, with [scale] pixels per point. Takes a second the first time, so do not call it on a window's thread. */
    fun png(scale: Int = PICTURE_SCALE): ByteArray = SvgRaster.png(svg, WIDTH * scale, HEIGHT * scale)

    companion object {
        /** The width in points. */
        const val WIDTH: Int = 900

        /** The height in points. */
        const val HEIGHT: Int = 420

        /** The number of pixels per point that is sharp in print, and on screens of a high density. */
        const val PICTURE_SCALE: Int = 2
    }
}
