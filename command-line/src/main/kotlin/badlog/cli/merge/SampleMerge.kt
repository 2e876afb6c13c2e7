package badlog.cli.merge

import badlog.cli.topic.called
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic
import badlog.recording.TopicKind

/** Makes one recording of logs whose topics have times of their own. */
internal class SampleMerge(parts: List<LogPart>, mode: MergeMode) {
    private val groups = mode.groupsOf(parts).map { group -> group.sortedBy { it.firstX } }
    private val names = MergedNames()
    private val valueNames = MergedNames()

    /** A topic that several logs of a group may have: [name] in [part], the first of them, and its pieces in their order. */
    private class Lane(val name: String, val part: LogPart, val pieces: MutableList<Topic>) {
        fun takes(topic: Topic) = name == topic.name &&
            (topic.kind == TopicKind.EMPTY || pieces.all { it.kind == TopicKind.EMPTY || isText(it) == isText(topic) })

        private fun isText(topic: Topic) = topic.kind == TopicKind.STATE || topic.kind == TopicKind.EVENT
    }

    /** What came of it. To be called once. */
    fun merged(): Merged {
        val topics = ArrayList<Topic>()
        val told = groups.map { group ->
            var repeated = 0
            for (lane in lanesOf(group)) {
                val appended = AppendedSamples(lane.pieces)
                repeated += appended.repeated
                topics += appended.topic.called(names.freeName(lane.name, lane.part))
            }
            Merged.Group(group, repeated)
        }
        val values = valueNames.values(groups.flatten())
        val recording = Recording(RecordingFormat.WPILOG, null, values, topics, 0, emptyList())
        return Merged(recording, told, names.renamed + valueNames.renamed)
    }

    /** Numbers and texts of one name do not become one topic. */
    private fun lanesOf(group: List<LogPart>): List<Lane> {
        val lanes = LinkedHashMap<String, MutableList<Lane>>()
        for (part in group) {
            for (topic in part.recording.topics) {
                val alike = lanes.getOrPut(topic.name) { ArrayList() }
                val lane = alike.find { it.takes(topic) }
                if (lane == null) alike += Lane(topic.name, part, arrayListOf(topic)) else lane.pieces += topic
            }
        }
        return lanes.values.flatten()
    }
}
