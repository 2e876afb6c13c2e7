package badlog.charts.look

import org.jetbrains.letsPlot.awt.plot.PlotSvgExport
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.intern.toSpec

/** Returns [plot] as a scalable SVG document with the accessible name [title]. */
internal fun svgOf(plot: Plot, title: String): String {
    val drawn = PlotSvgExport.buildSvgImageFromRawSpecs(plot.toSpec())
    check(drawn.startsWith(BEGIN)) { "lets-plot’s SVG begins with ${drawn.take(BEGIN.length)}" }
    // Without a view box, a larger width would only enlarge the background.
    return "$BEGIN viewBox=\"0 0 ${Chart.WIDTH} ${Chart.HEIGHT}\" role=\"img\" aria-label=\"$title\"" + drawn.removePrefix(BEGIN)
}

private const val BEGIN = "<svg"
