package badlog.cli.cut

import badlog.cli.input.Failure
import badlog.cli.input.Position
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.enabledSpans
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/** A way to select a part of a log by its x. */
internal fun interface PartChoice {
    /**
     * Returns the spans of x to keep; they may overlap.
     *
     * @throws badlog.cli.input.Failure if the log lacks the data for the selection.
     */
    fun spans(view: LogView): List<Span>
}

/** The range from [from] to [to], both included; null for no limit. */
internal class RangeChoice(private val from: Position?, private val to: Position?) : PartChoice {
    override fun spans(view: LogView): List<Span> {
        val span = Span(from?.on(view.xAxis) ?: Double.NEGATIVE_INFINITY, to?.on(view.xAxis) ?: Double.POSITIVE_INFINITY)
        if (span.from > span.to) throw Failure("--from $from comes after --to $to; swap them.")
        return listOf(span)
    }
}

/** The time while the robot was enabled, and [margin] before and after. */
internal class EnabledChoice(private val margin: Double) : PartChoice {
    override fun spans(view: LogView): List<Span> {
        val spans = view.enabledSpans()
        if (spans.isEmpty()) {
            throw Failure(
                "it does not show when the robot was enabled: it has no topic Enabled, or that is never true, or x goes backwards.",
            )
        }
        return spans.map { Span(it.span.from - margin, it.span.to + margin) }
    }
}

/** The time around each event, or change of state, with [text] in its text, regardless of case. */
internal class EventChoice(private val text: String, private val before: Double, private val after: Double) : PartChoice {
    override fun spans(view: LogView): List<Span> {
        val x = view.xAxis.positions
        val spans = view.recording.topics
            .flatMap { topic -> rowsOf(topic).mapNotNull { (topic.times ?: x).getOrNull(it) } }
            .filter { it.isFinite() }
            .map { Span(it - before, it + after) }
        return spans.ifEmpty { throw Failure("no event and no state contains “$text”.") }
    }

    private fun rowsOf(topic: Topic): List<Int> {
        val texts = topic.texts
        val hasText = BooleanArray(texts.dictionary.size) { texts.dictionary[it].contains(text, ignoreCase = true) }
        // A state is in every row; only its start counts.
        val isState = topic.kind == TopicKind.STATE && "log" !in topic.attributes
        return (0 until texts.size).filter { hasText[texts.ids[it]] && (!isState || begins(topic, it)) }
            .map { texts.rows[it] }
    }

    private fun begins(topic: Topic, index: Int): Boolean {
        val texts = topic.texts
        return index == 0 || texts.ids[index] != texts.ids[index - 1] || texts.rows[index] != texts.rows[index - 1] + 1
    }
}
