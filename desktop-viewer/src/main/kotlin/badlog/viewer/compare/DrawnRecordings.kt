package badlog.viewer.compare

import androidx.compose.ui.graphics.Color
import badlog.viewer.library.index.MatchFacts
import badlog.viewer.recording.OpenRecording
import badlog.viewer.theme.Palette

/**
 * A recording that graphs draw.
 *
 * @property offset what is added to its x to stand where the open recording has the same moment; 0 for that one itself.
 * @property name what it is called beside the others that are drawn.
 */
internal data class DrawnRecording(val recording: OpenRecording, val offset: Double = 0.0, val name: String = recording.label)

/**
 * What [recordings] are called beside each other, in their order: the match alone where all are of one event, and with the
 * name of the file where that would be the same twice.
 */
internal fun namesOf(recordings: List<OpenRecording>): List<String> {
    val facts = recordings.map { MatchFacts.of(it.view.recording.values, it.file.fileName.toString(), it.match) }
    val isOneEvent = facts.mapNotNull { it.event }.distinct().size <= 1
    val names = recordings.mapIndexed { i, recording -> facts[i].match?.takeIf { isOneEvent } ?: recording.label }
    val isDistinct = names.distinct().size == names.size
    return if (isDistinct) names else recordings.mapIndexed { i, recording -> "${names[i]} (${recording.file.fileName})" }
}

/** [label] in at most [letters], without its middle where it is longer: matches of one event differ at their end. */
internal fun shortLabel(label: String, letters: Int): String {
    if (label.length <= letters) return label
    val end = (letters - 1) / 2
    return label.take(letters - 1 - end).trimEnd() + "…" + label.takeLast(end).trimStart()
}

/** The color of the recording that is number [index] among those drawn, while several are compared. */
internal fun Palette.colorOf(index: Int): Color = line(index)
