package badlog.formats.wpilog

import badlog.core.recording.CellCounts
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.text.UniqueNames
import badlog.formats.column.reportTopic

/** Creates the topics of the entries, each with a unique name. Keeps samples within [span], in s. */
internal class WpilogTopics(private val span: ClosedFloatingPointRange<Double>, private val problems: ProblemList) {
    private val names = UniqueNames()
    private val topics = ArrayList<Topic>()

    fun of(entries: Collection<Entry>): List<Topic> {
        for (entry in entries) if (!entry.isValue) add(entry)
        return topics
    }

    private fun add(entry: Entry) {
        val decoder = entry.decoder
        decoder.timestamps.finish(span)
        val role = entry.formerRole
        val withoutSamples = Topic(
            entry.name,
            entry.unit,
            entry.attributes,
            DoubleArray(0),
            TextColumn.EMPTY,
            decoder.timestamps.run { order?.size ?: size }.let { CellCounts(0, 0, 0, 0, it, if (it > 0) 1 else 0) },
            decoder.timestamps.times,
            formerTypeIn(role) ?: entry.type,
            entry.metadata,
            wasXAxis = role == X_AXIS,
            wasSparse = role == SPARSE,
        )
        // An entry without records, or with only empty arrays, is still a topic.
        if (decoder.blocks.none { it.columns.isNotEmpty() }) topics += withoutSamples.copy(name = uniqueName(entry.name))
        for (block in decoder.blocks) {
            block.timestamps.finish(span)
            for (column in block.columns) {
                val name = uniqueName(entry.name + column.path)
                val topic = withoutLog(column.build(name, withoutSamples, block.timestamps))
                reportTopic(topic, column, block.timestamps, problems)
                topics += topic
            }
        }
    }

    // In an event message, only texts are events; times and counts beside them are numbers.
    private fun withoutLog(topic: Topic) =
        if (topic.counts.texts == 0 && topic.type.startsWith("proto:")) topic.copy(attributes = topic.attributes - LOG) else topic

    private fun uniqueName(wanted: String): String {
        val name = names.give(wanted)
        if (name != wanted) {
            problems.add(
                ProblemKind.DUPLICATE_TOPIC,
                "Two topics are named “$wanted”; the second is shown as “$name”.",
                topic = name,
            )
        }
        return name
    }
}
