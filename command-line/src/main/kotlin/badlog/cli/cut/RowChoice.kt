package badlog.cli.cut

import badlog.analysis.LogView
import badlog.plot.Span

/** A way to choose rows of a log by their x. */
internal fun interface RowChoice {
    /**
     * Which stretches of x to keep; may overlap.
     *
     * @throws badlog.cli.Failure when the log has nothing to choose by.
     */
    fun spans(view: LogView): List<Span>
}
