package badlog.window.graph.plot

import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.axis.axisLimits
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.curve.Strokes

/** Returns the y scales for [axes], of which [seen] is visible, on a plot [height] pixels high. */
internal fun yAxesOf(request: PlotRequest, axes: List<GraphAxis>, seen: List<SeenOfUnit>, height: Float): List<YAxis> {
    val spec = request.spec
    val wholes = seen.map { limitsFor(it.least, it.most, spec.includesZero) }
    val shown = axisLimits(axes, wholes, spec.yRange, spec.rightYRange)
    return axes.mapIndexed { i, axis -> YAxis(axis, wholes[i], shown[i], Ticks.ofY(shown[i], (height / request.density).toDouble())) }
}

/** Returns what is visible of the lines of one [unit] with these [strokes]. */
internal fun seenOf(unit: String, strokes: List<Strokes>): SeenOfUnit {
    val seen = strokes.filter { !it.min.isNaN() }
    return SeenOfUnit(unit, seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN)
}
