package badlog.page.findings

import badlog.core.analysis.LogView
import badlog.core.recording.TopicKind
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.saveFile
import badlog.page.rules.AssignedSignals
import badlog.page.view.Notice
import badlog.signals.assigning
import badlog.signals.refusalOf
import badlog.signals.vocabulary.SignalVocabulary
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
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
    private val topics by lazy { log.recording.topics.filter { it.kind != TopicKind.EMPTY }.map { it.name } }

    /** What was said before, and how to take it back. */
    val chosen: HTMLElement = element("p", "signals-chosen") {
        val ofThisLog = AssignedSignals.of(log.recording)
        for ((signal, topic) in ofThisLog) {
            add("span", "", "“$signal” is “$topic” in this browser.")
            addButton("text-button", "Forget “$signal”") {
                AssignedSignals.forget(signal)
                onChange()
            }
        }
        addButton("text-button", "Save badlog-signals.toml", "For the folder of your logs: there, window and command line use it") {
            saveFile(Blob(arrayOf(AssignedSignals.fileOf(ofThisLog))), "badlog-signals.toml")
        }
        isHidden = ofThisLog.isEmpty()
    }

    /** Returns fields for the signals [lacking]: each asks which topic that is. */
    fun fieldsFor(lacking: List<String>): HTMLElement = element("div", "signals-lacking") {
        for (signal in lacking.take(MOST)) {
            add("label", "", "“$signal” is ") {
                add("input") {
                    setAttribute("list", LIST)
                    setAttribute("placeholder", "a topic…")
                    val field = unsafeCast<HTMLInputElement>()
                    field.onchange = { if (field.value.isNotEmpty()) assign(signal, field.value) }
                }
            }
        }
        add("datalist") {
            id = LIST
            for (topic in topics) add("option") { setAttribute("value", topic) }
        }
    }

    private fun assign(signal: String, topic: String) {
        val refusal = refusalOf(signal, topic, log, signals.assigning(signal, topic))
        if (refusal != null) return notice.say(refusal)
        AssignedSignals.assign(signal, topic)
        onChange()
    }

    private companion object {
        const val LIST = "signal-topics"

        /** As many as a person names at a time. */
        const val MOST = 5
    }
}
