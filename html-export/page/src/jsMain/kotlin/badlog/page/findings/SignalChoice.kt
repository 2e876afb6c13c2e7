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
 * Lets a person say which topic of [log] is a signal that rules lack.
 *
 * @param signals the names of signals that the page knows.
 * @param onChange called when a signal has another topic: everything depends on it.
 */
internal class SignalChoice(
    private val log: LogView,
    private val signals: SignalVocabulary,
    private val notice: Notice,
    private val onChange: () -> Unit,
) {
    /** The topics that can be a signal. */
    val topics: List<String> by lazy { log.recording.topics.filter { it.kind != TopicKind.EMPTY }.map { it.name } }

    /** The topic of each signal that a reader named. */
    val assigned: Map<String, String> = AssignedSignals.of(log.recording).associate { it.key to it.value }

    /** Makes [topic] the signal [signal], or says why it cannot be that. */
    fun assign(signal: String, topic: String) {
        val refusal = refusalOf(signal, topic, log, signals.assigning(signal, topic))
        if (refusal != null) return notice.say(refusal)
        AssignedSignals.assign(signal, topic)
        onChange()
    }

    /** Makes [signal] what it was before. */
    fun forget(signal: String) {
        AssignedSignals.forget(signal)
        onChange()
    }

    /** Saves what was assigned as a file, for the folder of logs. */
    fun save() = saveFile(Blob(arrayOf(AssignedSignals.fileOf(AssignedSignals.of(log.recording)))), "badlog-signals.toml")
}
