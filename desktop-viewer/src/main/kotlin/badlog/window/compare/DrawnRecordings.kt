package badlog.window.compare

import androidx.compose.ui.graphics.Color
import badlog.window.log.OpenRecording
import badlog.window.theme.Palette

/**
 * A recording that graphs draw.
 *
 * @property offset what is added to its x to align it with the open recording; 0 for that one itself.
 * @property name its name beside the other drawn ones.
 */
internal data class DrawnRecording(val recording: OpenRecording, val offset: Double = 0.0, val name: String = recording.label)

/**
 * Returns the names of [recordings] beside each other, in order: only the match if all are of the same event, with the
 * file name if names would be equal.
 */
internal fun namesOf(recordings: List<OpenRecording>): List<String> {
    val facts = recordings.map { it.match.orNamed(it.file.fileName.toString()) }
    val isOneEvent = facts.mapNotNull { it.event }.distinct().size <= 1
    val names = recordings.mapIndexed { i, recording -> facts[i].match?.takeIf { isOneEvent } ?: recording.label }
    val isDistinct = names.distinct().size == names.size
    return if (isDistinct) names else recordings.mapIndexed { i, recording -> "${names[i]} (${recording.file.fileName})" }
}

/** Returns [label] in at most [letters], shortened in the middle if necessary: matches of one event differ at their end. */
internal fun shortLabel(label: String, letters: Int): String {
    if (label.length <= letters) return label
    val end = (letters - 1) / 2
    return label.take(letters - 1 - end).trimEnd() + "…" + label.takeLast(end).trimStart()
}

/** Returns the color of the drawn recording [index], while several are compared. */
internal fun Palette.colorOf(index: Int): Color = line(index)
