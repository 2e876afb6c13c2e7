package badlog.viewer.compare

import badlog.viewer.library.index.MatchFacts
import badlog.viewer.recording.OpenRecording

/**
 * What [recordings] are called beside each other, in their order: the match alone where all are of one event, and with the
 * name of the file where that would be the same twice.
 */
internal fun namesOf(recordings: List<OpenRecording>): List<String> {
    val facts = recordings.map { MatchFacts.of(it.view.recording.values, it.file.fileName.toString()) }
    val isOneEvent = facts.mapNotNull { it.event }.distinct().size <= 1
    val names = recordings.mapIndexed { i, recording -> facts[i].match?.takeIf { isOneEvent } ?: recording.label }
    val isDistinct = names.distinct().size == names.size
    return if (isDistinct) names else recordings.mapIndexed { i, recording -> "${names[i]} (${recording.file.fileName})" }
}
