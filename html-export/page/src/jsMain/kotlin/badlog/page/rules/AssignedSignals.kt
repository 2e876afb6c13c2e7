package badlog.page.rules

import badlog.core.json.quotedJson
import badlog.page.dom.LocalStorage
import badlog.rules.RuleSet
import badlog.signals.assigning

/** The topics that readers of pages have named as signals: this browser remembers them for all logs that have these topics. */
internal object AssignedSignals {
    private const val KEY = "signals"

    /** Names of signals have only letters, digits and spaces, and hardly any topic has this. */
    private const val SEPARATOR = '\u0000'

    /** The topic of each signal that was named. */
    var topics: Map<String, String> = remembered()
        private set

    /** Makes [topic] the signal [signal]. */
    fun assign(signal: String, topic: String) = change { it + (signal to topic) }

    /** Makes the signal [signal] what it was before. */
    fun forget(signal: String) = change { it - signal }

    /** Returns [rules] with these names of signals. */
    fun over(rules: RuleSet): RuleSet = if (topics.isEmpty()) {
        rules
    } else {
        rules.with(topics.entries.fold(rules.signals) { names, (signal, topic) -> names.assigning(signal, topic) })
    }

    /** Returns [chosen], signals and their topics, as a file that the other programs of badlog read. */
    fun fileOf(chosen: List<Map.Entry<String, String>>): String = chosen.joinToString("\n") { (signal, topic) ->
        "[[signal]]\nname = ${quotedJson(signal)}\ntopics = [${quotedJson(topic)}]\n"
    }

    private fun change(step: (Map<String, String>) -> Map<String, String>) {
        // Other tabs may have named some, too.
        topics = step(topics + remembered())
        LocalStorage[KEY] = topics.entries.joinToString("$SEPARATOR") { "${it.key}$SEPARATOR${it.value}" }
    }

    private fun remembered(): Map<String, String> =
        LocalStorage[KEY].orEmpty().split(SEPARATOR).chunked(2).filter { it.size == 2 }.associate { (signal, topic) -> signal to topic }
}
