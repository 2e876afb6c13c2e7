package badlog.cli.merge

import badlog.cli.topic.CellSource
import badlog.cli.topic.TopicBuilder
import badlog.recording.Topic
import badlog.recording.TopicKind

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
