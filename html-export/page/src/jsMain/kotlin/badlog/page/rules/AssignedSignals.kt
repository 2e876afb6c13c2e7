package badlog.page.rules

import badlog.core.json.quotedJson
import badlog.core.recording.Recording
import badlog.core.recording.TopicKind
import badlog.page.dom.LocalStorage
import badlog.rules.RuleSet
import badlog.signals.assigning

/** The topics that readers of pages have named as signals: this browser remembers them for all logs that have these topics. */
internal object AssignedSignals {
    private const val KEY = "signals"

    /** Names of signals have only letters, digits and spaces, and hardly any topic has this. */
    private const val SEPARATOR = '\u0000'

    /** The topic of each signal that was named. */
    var topics: Map<String, String> = remembered().orEmpty()
        private set

    /** Makes [topic] the signal [signal]. */
    fun assign(signal: String, topic: String) = change { it + (signal to topic) }

    /** Makes the signal [signal] what it was before. */
    fun forget(signal: String) = change { it - signal }

    /** Returns those whose topics [log] has. */
    fun of(log: Recording): List<Map.Entry<String, String>> {
        val names = log.topics.filter { it.kind != TopicKind.EMPTY }.mapTo(HashSet()) { it.name }
        return topics.entries.filter { it.value in names }
    }

    /** Returns [rules] with [named], signals and their topics. */
    fun over(rules: RuleSet, named: Collection<Map.Entry<String, String>> = topics.entries): RuleSet = if (named.isEmpty()) {
        rules
    } else {
        rules.with(named.fold(rules.signals) { names, (signal, topic) -> names.assigning(signal, topic) })
    }

    /** Returns [chosen], signals and their topics, as a file that the other programs of badlog read. */
    fun fileOf(chosen: List<Map.Entry<String, String>>): String = chosen.joinToString("\n") { (signal, topic) ->
        "[[signal]]\nname = ${quotedJson(signal)}\ntopics = [${quotedJson(topic)}]\n"
    }

    private fun change(step: (Map<String, String>) -> Map<String, String>) {
        // Other tabs may have named or forgotten some, too.
        topics = step(remembered() ?: topics)
        LocalStorage[KEY] = topics.entries.joinToString("$SEPARATOR") { "${it.key}$SEPARATOR${it.value}" }
    }

    /** Null if nothing is stored, as where that is forbidden. */
    private fun remembered(): Map<String, String>? =
        LocalStorage[KEY]?.split(SEPARATOR)?.chunked(2)?.filter { it.size == 2 }?.associate { (signal, topic) -> signal to topic }
}
