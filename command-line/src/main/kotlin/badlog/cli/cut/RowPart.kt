package badlog.cli.cut

import badlog.analysis.LogView
import badlog.cli.Failure
import badlog.cli.text.XTime
import badlog.plot.Span

/**
 * The rows of [view] that lie in [spans].
 *
 * @throws Failure when there are none.
 */
internal fun rowPart(view: LogView, spans: List<Span>): CutPart {
    val x = view.xAxis.positions
    val runs = rowsIn(x, spans).runs()
    if (runs.isEmpty()) throw nothingThere(view, "row")
    return CutPart(view.recording, runs, runs.map { Span(x[it.first], x[it.last]) })
}

/** What to say where no [noun] of [view] lies in what was asked for. */
internal fun nothingThere(view: LogView, noun: String): Failure {
    val axis = view.xAxis
    val range = axis.range ?: return Failure("it has no ${noun}s to keep any of.")
    val text = "from ${XTime.text(range.start, axis.unit)} to ${XTime.text(range.endInclusive, axis.unit)}"
    return Failure("no $noun lies there; ${axis.name} goes $text.")
}
