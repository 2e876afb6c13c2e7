package badlog.cli.merge

import badlog.recording.Topic

/** Whether cell [index] of [one] says the same as cell [otherIndex] of [other]. */
internal fun isSameCell(one: Topic, index: Int, other: Topic, otherIndex: Int): Boolean =
    numberAt(one, index) == numberAt(other, otherIndex) && textAt(one, index) == textAt(other, otherIndex)

private fun numberAt(topic: Topic, index: Int) = (if (topic.samples.isEmpty()) Double.NaN else topic.samples[index]).toBits()

private fun textAt(topic: Topic, index: Int): String? {
    val place = topic.texts.rows.binarySearch(index)
    return if (place < 0) null else topic.texts[place]
}
