package badlog.cli.cut

import badlog.analysis.LogView
import badlog.cli.input.Position
import badlog.plot.Span

/** What lies from [from] to [to], both included; null is without end. */
internal class RangeChoice(private val from: Position?, private val to: Position?) : PartChoice {
    override fun spans(view: LogView): List<Span> = listOf(
        Span(from?.on(view.xAxis) ?: Double.NEGATIVE_INFINITY, to?.on(view.xAxis) ?: Double.POSITIVE_INFINITY),
    )
}
