package badlog.cli.cut

import badlog.analysis.LogView
import badlog.analysis.enabledSpans
import badlog.cli.Failure
import badlog.plot.Span

/** What the robot did while it was enabled, and [margin] before and after. */
internal class EnabledChoice(private val margin: Double) : PartChoice {
    override fun spans(view: LogView): List<Span> {
        val spans = view.enabledSpans()
        if (spans.isEmpty()) {
            throw Failure(
                "it does not tell when the robot was enabled: no topic is called Enabled, or it never is true, or x goes backwards.",
            )
        }
        return spans.map { Span(it.span.from - margin, it.span.to + margin) }
    }
}
