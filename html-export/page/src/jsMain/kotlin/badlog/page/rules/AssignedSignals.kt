package badlog.page.rules

import badlog.core.json.quotedJson
import badlog.core.recording.Recording
import badlog.core.recording.TopicKind
import badlog.page.dom.LocalStorage
import badlog.rules.RuleSet
import badlog.signals.assigning

/** The topics that the reader assigned to signals, which the browser remembers for all logs with these topics. */
internal object AssignedSignals {
    private const val KEY = "signals"

    /** Separates names and topics; names of signals have only letters, digits and spaces, and hardly any topic contains it. */
    private const val SEPARATOR = '\u0000'

    /** The topic of each assigned signal. */
    var topics: Map<String, String> = remembered().orEmpty()
        private set

    /** Assigns [topic] to [signal], instead of the topic assigned before; the browser remembers it. */
    fun assign(signal: String, topic: String) = change { it + (signal to topic) }

    /** Removes the assignment of [signal]. */
    fun forget(signal: String) = change { it - signal }

    /** Returns the assignments to topics in [log]. */
    fun of(log: Recording): List<Map.Entry<String, String>> {
        val names = log.topics.filter { it.kind != TopicKind.EMPTY }.mapTo(HashSet()) { it.name }
        return topics.entries.filter { it.value in names }
    }

    /** Returns [rules] with the assignments [named]. */
    fun over(rules: RuleSet, named: Collection<Map.Entry<String, String>> = topics.entries): RuleSet = if (named.isEmpty()) {
        rules
    } else {
        rules.with(named.fold(rules.signals) { names, (signal, topic) -> names.assigning(signal, topic) })
    }

    /** Returns [chosen], signals and their topics, as a file for the other programs of badlog. */
    fun fileOf(chosen: List<Map.Entry<String, String>>): String = chosen.joinToString("\n") { (signal, topic) ->
        "[[signal]]\nname = ${quotedJson(signal)}\ntopics = [${quotedJson(topic)}]\n"
    }

    private fun change(step: (Map<String, String>) -> Map<String, String>) {
        // Other tabs may have changed assignments, too.
        topics = step(remembered() ?: topics)
        LocalStorage[KEY] = topics.entries.joinToString("$SEPARATOR") { "${it.key}$SEPARATOR${it.value}" }
    }

    /** Null if nothing is stored, for example because storing is forbidden. */
    private fun remembered(): Map<String, String>? =
        LocalStorage[KEY]?.split(SEPARATOR)?.chunked(2)?.filter { it.size == 2 }?.associate { (signal, topic) -> signal to topic }
}
