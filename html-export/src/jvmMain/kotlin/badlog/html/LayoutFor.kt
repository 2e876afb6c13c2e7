package badlog.html

import badlog.file.UnreadableFileException
import badlog.file.readRecording
import badlog.formats.LOG_FORMATS
import badlog.plot.board.FolderLayout
import badlog.rules.signal.SignalVocabulary
import badlog.rules.signal.matchOf
import java.nio.file.Path

/**
 * The layout with which a page of [log] begins, see [FolderLayout.of]. Reads the log, where there is a layout for a type of matches.
 *
 * @param signals the names of the topics that say the type.
 * @param top the folder up to which a layout is looked for; null for that of the log alone.
 */
public fun layoutFor(log: Path, signals: SignalVocabulary, top: Path? = null): FolderLayout =
    FolderLayout.of(log, top) { matchTypeOf(log, signals) }

private fun matchTypeOf(log: Path, signals: SignalVocabulary): String? = try {
    val recording = readRecording(log, LOG_FORMATS, keepSamples = false)
    // A bag says it at its beginning, a log of records mostly by numbers.
    signals.matchOf(recording).type
        ?: if (recording.format.hasRows) null else signals.matchOf(readRecording(log, LOG_FORMATS)).type
} catch (_: UnreadableFileException) {
    // Whoever makes the page says why.
    null
}
