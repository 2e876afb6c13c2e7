package badlog.viewer.graph.plot

import badlog.analysis.Span
import badlog.plot.axis.Ticks
import badlog.plot.axis.YLimits
import badlog.plot.curve.Strokes

/**
 * The scales of y for [units], each so that the points [strokesOf] gives for it fill the graph. A person's choice of y is of the
 * first unit; the others keep the same part of theirs, so that all lines move together.
 */
internal fun axesOf(request: PlotRequest, units: List<String>, height: Float, strokesOf: (String) -> List<Strokes>): List<YAxis> {
    val fitted = units.map { unit -> fit(strokesOf(unit), request.spec.includesZero) }
    val first = fitted.firstOrNull() ?: return emptyList()
    val chosen = request.spec.yRange?.takeIf { it.width > 0 && it.width.isFinite() }
    return units.mapIndexed { index, unit ->
        val whole = fitted[index]
        val shown = when {
            chosen == null -> whole

            index == 0 -> chosen

            else -> Span(
                whole.from + (chosen.from - first.from) / first.width * whole.width,
                whole.from + (chosen.to - first.from) / first.width * whole.width,
            )
        }
        YAxis(unit, whole, shown, Ticks.ofY(shown, (height / request.density).toDouble()))
    }
}

private fun fit(strokes: List<Strokes>, includesZero: Boolean): Span {
    val seen = strokes.filter { !it.min.isNaN() }
    val limits = YLimits()
    limits.fit(seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN, includesZero)
    return Span(limits.from, limits.to)
}
