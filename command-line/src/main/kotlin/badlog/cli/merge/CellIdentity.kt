package badlog.cli.merge

import badlog.core.recording.Topic

/** Returns whether cell [index] of [one] has the same content as cell [otherIndex] of [other]. */
internal fun isSameCell(one: Topic, index: Int, other: Topic, otherIndex: Int): Boolean =
    numberAt(one, index) == numberAt(other, otherIndex) && textAt(one, index) == textAt(other, otherIndex)

private fun numberAt(topic: Topic, index: Int) = (if (topic.samples.isEmpty()) Double.NaN else topic.samples[index]).toBits()

private fun textAt(topic: Topic, index: Int): String? {
    val place = topic.texts.rows.binarySearch(index)
    return if (place < 0) null else topic.texts[place]
}

/** Decides whether a row of [one] and a row of [other] are the same in every cell. They never are if their topics differ. */
internal class RowIdentity(one: LogPart, other: LogPart) {
    private val areAlike = one.recording.topics.size == other.recording.topics.size
    private val pairs = one.recording.topics.map { it to other.topic(it.name) }

    /** Returns whether row [row] of the first log is the same as row [otherRow] of the other. */
    fun isSame(row: Int, otherRow: Int): Boolean =
        areAlike && pairs.all { (topic, twin) -> twin != null && isSameCell(topic, row, twin, otherRow) }
}
