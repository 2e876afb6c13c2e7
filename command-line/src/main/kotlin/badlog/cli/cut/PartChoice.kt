package badlog.cli.cut

import badlog.analysis.LogView
import badlog.plot.Span

/** A way to choose a part of a log by its x. */
internal fun interface PartChoice {
    /**
     * Which stretches of x to keep; may overlap.
     *
     * @throws badlog.cli.Failure when the log has nothing to choose by.
     */
    fun spans(view: LogView): List<Span>
}
