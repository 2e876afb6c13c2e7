package badlog.page.findings

import badlog.core.analysis.LogView
import badlog.core.recording.TopicKind
import badlog.page.dom.saveFile
import badlog.page.rules.AssignedSignals
import badlog.page.view.Notice
import badlog.signals.assigning
import badlog.signals.refusalOf
import badlog.signals.vocabulary.SignalVocabulary
import org.w3c.files.Blob

/**
 * Lets a person assign topics of [log] to signals that rules lack.
 *
 * @param signals the vocabulary of the page.
 * @param onChange called when a signal has another topic, because everything depends on it.
 */
internal class SignalChoice(
    private val log: LogView,
    private val signals: SignalVocabulary,
    private val notice: Notice,
    private val onChange: () -> Unit,
) {
    /** The topics that can be a signal. */
    val topics: List<String> by lazy { log.recording.topics.filter { it.kind != TopicKind.EMPTY }.map { it.name } }

    /** The topic of each signal that the reader assigned. */
    val assigned: Map<String, String> = AssignedSignals.of(log.recording).associate { it.key to it.value }

    /** Assigns [topic] to [signal], or shows why that is impossible. */
    fun assign(signal: String, topic: String) {
        val refusal = refusalOf(signal, topic, log, signals.assigning(signal, topic))
        if (refusal != null) return notice.say(refusal)
        AssignedSignals.assign(signal, topic)
        onChange()
    }

    /** Restores the original topic of [signal]. */
    fun forget(signal: String) {
        AssignedSignals.forget(signal)
        onChange()
    }

    /** Saves the assignments as a file for the folder of logs. */
    fun save() = saveFile(Blob(arrayOf(AssignedSignals.fileOf(AssignedSignals.of(log.recording)))), "badlog-signals.toml")
}
