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
 * The file that names a team's signals for the log [log]: the nearest one in its folder or, up to the folder [library], above it. While
 * there is none, it is a new one beside the log; a null [library] means the log's own folder only.
 */
class SignalAssignment(log: Path, library: Path?) {
    /** The file, which may not exist yet. */
    val file: Path = nearestTo(log, library).file ?: log.resolveSibling(SignalsFile.NAME)

    /**
     * Makes [topic] of [view] the signal [signal] in all logs that the file is for.
     *
     * @return why it is not, as a sentence; null if it is.
     */
    fun assign(signal: String, topic: String, view: LogView): String? {
        // Read again, for another window or program may have written it meanwhile.
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
