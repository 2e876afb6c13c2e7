package badlog.catalog.folder

import badlog.core.analysis.LogView
import badlog.files.UnwritableFileException
import badlog.files.writeAtomically
import badlog.rules.BUILT_IN
import badlog.rules.NearestFile
import badlog.rules.RuleSet
import badlog.rules.RulesException
import badlog.rules.SignalsFile
import badlog.signals.refusalOf
import java.nio.file.Files
import java.nio.file.Path

/**
 * The file that names a team's signals for the log [log]. It is the nearest one in its folder or above it, up to the folder [library]. If
 * there is none, it is a new one beside the log; a null [library] means only the log's own folder.
 */
class SignalAssignment(log: Path, library: Path?) {
    /** The file, which may not exist yet. */
    val file: Path = nearestTo(log, library).file ?: log.resolveSibling(SignalsFile.NAME)

    /**
     * Assigns [topic] of [view] to the signal [signal] in all logs to which the file applies.
     *
     * @return the reason for a failure, as a sentence; null on success.
     */
    fun assign(signal: String, topic: String, view: LogView): String? {
        // Read again, because another window or program may have written it meanwhile.
        val nearest = nearestTo(file, null)
        if (nearest.problem != null) return "$file is not changed: ${nearest.problem}"
        return try {
            val text = SignalsFile.withTopic(nearest.found.orEmpty(), signal, topic)
            val refusal = refusalOf(signal, topic, view, RuleSet.BUILT_IN.signals.with(SignalsFile.parse(text)))
            if (refusal == null) writeAtomically(file) { it.write(text.encodeToByteArray()) }
            refusal
        } catch (e: RulesException) {
            e.message
        } catch (e: UnwritableFileException) {
            e.message
        }
    }

    private fun nearestTo(log: Path, library: Path?) =
        NearestFile.of(log, library, { it.resolve(SignalsFile.NAME).takeIf(Files::isRegularFile) }) { text ->
            text.also(SignalsFile::parse)
        }
}
