package badlog.cli.convert

import badlog.cli.output.LeftOut
import badlog.cli.text.counted
import badlog.recording.Recording
import badlog.recording.Topic
import badlog.recording.TopicKind

/** What of [recording], whose topics have times of their own, is not told by rows at [times]. */
internal fun rowLosses(recording: Recording, times: DoubleArray): LeftOut {
    val between = recording.topics.sumOf { samplesBetween(it, times) }
    val topics = recording.topics
    return LeftOut(
        listOfNotNull(
            if (between == 0L) null else counted(between, "sample") + " between rows",
            LeftOut.thing(topics.count { it.type.isNotEmpty() }, "type"),
            topicsText("the metadata", topics.count { it.metadata.isNotEmpty() }),
            topicsText("the bytes", topics.count { it.type == "raw" || it.type.startsWith("proto:") }),
        ),
    )
}

private fun topicsText(what: String, count: Int): String? = if (count == 0) null else "$what of ${counted(count.toLong(), "topic")}"

/** How many samples of [topic] no row at [times] shows. */
private fun samplesBetween(topic: Topic, times: DoubleArray): Long {
    val own = topic.times ?: return 0
    // All events before a row stand in it.
    if (topic.kind == TopicKind.EVENT || "log" in topic.attributes) {
        return own.count { times.isEmpty() || it > times.last() }.toLong()
    }
    var lost = 0L
    var row = 0
    for (i in own.indices) {
        while (row < times.size && times[row] < own[i]) row++
        val isShown = row < times.size && (i == own.lastIndex || own[i + 1] > times[row])
        if (!isShown) lost++
    }
    return lost
}
