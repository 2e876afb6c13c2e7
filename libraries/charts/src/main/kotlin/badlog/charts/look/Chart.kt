package badlog.charts.look

import org.jetbrains.letsPlot.intern.Plot

/**
 * A chart of many logs. It has a white background and is self-contained: it needs no script, no font and no network.
 *
 * @property name its name in names of files: lower-case letters and `-`.
 * @property title its title.
 * @property question the question of a team that it answers.
 * @property reading a sentence about how to read it.
 */
class Chart private constructor(val name: String, val title: String, val question: String, val reading: String, private val plot: Plot) {
    internal constructor(texts: ChartTexts, reading: String, plot: Plot) : this(texts.name, texts.title, texts.question, reading, plot)

    private val svg by lazy { svgOf(plot, title) }

    /** Returns the chart as an SVG document of [WIDTH] × [HEIGHT] points. */
    fun svg(): String = svg

    /** Returns the chart as a PNG with [scale] pixels per point. The first call takes a second, so do not call it on a window's thread. */
    fun png(scale: Int = PICTURE_SCALE): ByteArray = SvgRaster.png(svg, WIDTH * scale, HEIGHT * scale)

    companion object {
        /** The width in points. */
        const val WIDTH: Int = 900

        /** The height in points. */
        const val HEIGHT: Int = 420

        /** The number of pixels per point for print and high-density screens. */
        const val PICTURE_SCALE: Int = 2
    }
}
