package badlog.exporter

import badlog.files.ReadOptions
import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.choices.board.FolderLayout
import java.nio.file.Path

/**
 * Returns the layout with which a page of [log] begins, see [FolderLayout.of]. Reads the log if there is a layout for a type of match.
 *
 * @param signals the vocabulary that names the topics with the type of match.
 * @param top the last parent folder to search for a layout; null to search only the log's own folder.
 */
fun layoutFor(log: Path, signals: SignalVocabulary, top: Path? = null): FolderLayout =
    FolderLayout.of(log, top) { matchTypeOf(log, signals) }

private fun matchTypeOf(log: Path, signals: SignalVocabulary): String? = try {
    val head = readRecording(log, LOG_FORMATS, ReadOptions(keepSamples = false))
    // Logs of records usually have the type in numbers, which the first reading does not keep. These numbers always take precedence over
    // the file's name.
    val isKnown = head.format.hasRows || signals.matchOf(head, fileName = "").type != null
    val recording = if (isKnown) head else readRecording(log, LOG_FORMATS)
    signals.matchOf(recording, log.fileName.toString()).type
} catch (_: UnreadableFileException) {
    // The caller, which makes the page, reports the reason.
    null
} catch (_: UnwritableFileException) {
    // There is no room for temporary files, which the caller reports, too.
    null
}
