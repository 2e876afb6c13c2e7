package badlog.viewer.compare

import badlog.viewer.app.Viewer

/**
 * The recordings that every graph draws: the open one, then those ticked that were read, in the order of their ticks. One that is
 * both is there once. The place in this list is the place of a recording's colour, see [colorOf].
 */
internal fun Viewer.drawnRecordings(): List<DrawnRecording> {
    val open = open ?: return emptyList()
    val others = comparison.ticked.filter { it != open.file }.mapNotNull { comparison.loaded[it] }
    if (others.isEmpty()) return listOf(DrawnRecording(open))
    val names = namesOf(listOf(open) + others)
    return listOf(DrawnRecording(open, name = names[0])) +
        others.mapIndexed { i, other -> DrawnRecording(other, comparison.offsetOf(other, open), names[i + 1]) }
}
