package badlog.window.findings

import badlog.core.analysis.LogView
import badlog.files.writeAtomically
import badlog.rules.BUILT_IN
import badlog.rules.NearestFile
import badlog.rules.RuleSet
import badlog.rules.RulesException
import badlog.rules.SignalsFile
import badlog.signals.signalTopicsOf
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes [topic] of the log [log], which was read as [view], the signal [signal] of all logs of the folder: in the nearest file of
 * signals up to [library], or in a new one beside the log.
 *
 * @return why it is not, as a sentence; null if it is.
 */
internal fun assign(signal: String, topic: String, view: LogView, log: Path, library: Path?): String? {
    val nearest = NearestFile.of(log, library, { it.resolve(SignalsFile.NAME).takeIf(Files::isRegularFile) }) { text ->
        text.also(SignalsFile::parse)
    }
    if (nearest.problem != null) return "${nearest.file} is not changed: ${nearest.problem}"
    val file = nearest.file ?: log.resolveSibling(SignalsFile.NAME)
    return try {
        val text = SignalsFile.withTopic(nearest.found.orEmpty(), signal, topic)
        val vocabulary = RuleSet.BUILT_IN.signals.with(SignalsFile.parse(text))
        if (signalTopicsOf(view, vocabulary).of(signal).none { it.topic == topic }) {
            val known = vocabulary.find(signal)
            val what = known?.content?.name?.lowercase() + known?.unit?.let { " in $it" }.orEmpty()
            return "“$topic” cannot be “$signal”, which is a $what; choose another topic."
        }
        writeAtomically(file) { it.write(text.encodeToByteArray()) }
        null
    } catch (e: RulesException) {
        e.message
    } catch (_: IOException) {
        "$file cannot be written; check the permissions of its folder."
    }
}
