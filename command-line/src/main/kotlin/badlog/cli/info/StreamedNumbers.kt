package badlog.cli.info

import badlog.core.recording.NumberSink
import badlog.core.recording.NumberSinks
import badlog.core.recording.Topic

/** A summary of the numbers of a topic; only finite ones count. */
internal class NumberSummary : NumberSink {
    var count = 0
        private set

    /** The row, or the sample, of the first number; -1 if there are none. */
    var first = -1
        private set
    var last = -1
        private set
    var min = Double.POSITIVE_INFINITY
        private set
    var max = Double.NEGATIVE_INFINITY
        private set

    override fun add(row: Int, number: Double) {
        if (!number.isFinite()) return
        if (first < 0) first = row
        last = row
        count++
        if (number < min) min = number
        if (number > max) max = number
    }
}

/** Summarizes the numbers of a log while it is read. Numbers that are not otherwise [needed] take no memory. */
internal class StreamedNumbers(private val needed: NumberSinks) : NumberSinks {
    private val summaries = HashMap<String, NumberSummary>()

    override fun of(name: String, attributes: List<String>): NumberSink? =
        if (needed.of(name, attributes) == null) null else summaries.getOrPut(name, ::NumberSummary)

    /** Returns the summary of [topic], from its samples if it has them. */
    fun of(topic: Topic): NumberSummary = summaries[topic.name] ?: NumberSummary().also { summary ->
        topic.samples.forEachIndexed(summary::add)
    }
}
