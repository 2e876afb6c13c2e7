package badlog.cli.merge

import badlog.cli.topic.CellSource
import badlog.cli.topic.TopicBuilder
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
        val written = groups.map { group ->
            var repeated = 0
            for (lane in lanesOf(group)) {
                val appended = AppendedSamples(lane.pieces)
                repeated += appended.repeated
                topics += appended.topic.called(names.take(lane.name, lane.part))
            }
            Merged.Group(group, repeated)
        }
        val values = valueNames.values(groups.flatten())
        val recording = Recording(RecordingFormat.WPILOG, null, values, topics, 0, emptyList())
        return Merged(recording, written, names.renamed + valueNames.renamed)
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

/**
 * The samples of [pieces], topics with times of their own, in one topic in the order of time; of one time, those of the earlier
 * piece first. A sample that several have, of the same time and value, is there once.
 */
internal class AppendedSamples(private val pieces: List<Topic>) {
    /** How many samples were left out because another piece has them, too. */
    var repeated = 0
        private set

    /** The topic, called and described as the first piece that has anything. */
    val topic: Topic = pieces.singleOrNull() ?: append()

    private fun append(): Topic {
        val like = pieces.firstOrNull { it.kind != TopicKind.EMPTY } ?: pieces[0]
        val all = pieces.map { checkNotNull(it.times) }
        val builder = TopicBuilder(like.name, like, all.sumOf { it.size })
        val times = DoubleArray(all.sumOf { it.size })
        val sources = pieces.map(::CellSource)
        val next = IntArray(pieces.size)
        var size = 0
        while (true) {
            val piece = earliest(all, next)
            if (piece < 0) break
            val index = next[piece]++
            val time = all[piece][index]
            times[size++] = time
            sources[piece].addTo(builder, index)
            for (other in pieces.indices) {
                if (other == piece || next[other] == all[other].size || all[other][next[other]] != time) continue
                if (!isSameCell(pieces[piece], index, pieces[other], next[other])) continue
                next[other]++
                repeated++
            }
        }
        return builder.build(times.copyOf(size))
    }

    private fun earliest(all: List<DoubleArray>, next: IntArray): Int {
        var best = -1
        for (piece in all.indices) {
            if (next[piece] == all[piece].size) continue
            if (best < 0 || all[piece][next[piece]] < all[best][next[best]]) best = piece
        }
        return best
    }
}
