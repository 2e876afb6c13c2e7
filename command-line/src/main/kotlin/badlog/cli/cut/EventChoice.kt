package badlog.cli.cut

import badlog.analysis.LogView
import badlog.cli.Failure
import badlog.plot.Span
import badlog.recording.Topic
import badlog.recording.TopicKind

/** What lies around each event, or change of state, whose text contains [text] in any case of letters. */
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
        val isMeant = BooleanArray(texts.dictionary.size) { texts.dictionary[it].contains(text, ignoreCase = true) }
        // A state stands in every row; what happened is that it began.
        val isState = topic.kind == TopicKind.STATE && "log" !in topic.attributes
        return (0 until texts.size).filter { isMeant[texts.ids[it]] && (!isState || begins(topic, it)) }
            .map { texts.rows[it] }
    }

    private fun begins(topic: Topic, index: Int): Boolean {
        val texts = topic.texts
        return index == 0 || texts.ids[index] != texts.ids[index - 1] || texts.rows[index] != texts.rows[index - 1] + 1
    }
}
