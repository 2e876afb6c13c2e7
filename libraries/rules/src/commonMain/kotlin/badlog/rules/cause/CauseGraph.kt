package badlog.rules.cause

import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.itemsOf
import badlog.signals.json.jsonArray
import badlog.signals.json.jsonList
import badlog.signals.json.jsonObject
import badlog.signals.json.stringOf
import badlog.signals.vocabulary.NamePattern
import badlog.signals.vocabulary.patterns
import badlog.signals.vocabulary.patternsJson

/**
 * The rules' causes and effects: which findings show that something happened, and which findings may follow from which.
 *
 * @property causes the possible causes; if two explain the same finding, the earlier one counts.
 * @property effects for the name of each rule, the rules with findings that may follow from its findings.
 */
class CauseGraph internal constructor(internal val causes: List<Cause>, internal val effects: Map<String, List<String>>) {
    /** Returns the rules with findings that may follow from findings of [rules], directly or indirectly. */
    internal fun reachedFrom(rules: Collection<String>): Set<String> {
        val reached = LinkedHashSet<String>()
        val waiting = ArrayList(rules)
        while (waiting.isNotEmpty()) effects[waiting.removeAt(waiting.lastIndex)]?.forEach { if (reached.add(it)) waiting += it }
        return reached
    }

    /** Returns this graph with [own] in front; a cause in [own] replaces the cause here with the same name. */
    internal fun after(own: CauseGraph): CauseGraph {
        val names = own.causes.mapTo(HashSet()) { it.name }
        val all = (effects.keys + own.effects.keys).associateWith { own.effects[it].orEmpty() + effects[it].orEmpty() }
        return CauseGraph(own.causes + causes.filter { it.name !in names }, all)
    }

    companion object {
        /** No causes and no effects. */
        val NONE: CauseGraph = CauseGraph(emptyList(), emptyMap())

        internal fun fromJson(value: JsonValue): CauseGraph {
            val json = JsonFields(value.members)
            return CauseGraph(json.list("causes", ::causeOf), json.list("effects", ::effectOf).toMap())
        }
    }

    internal fun toJson(): String = jsonObject(
        "causes" to jsonArray(causes, ::causeJson),
        "effects" to jsonArray(effects.entries.toList()) { (rule, followers) -> jsonArray(listOf(rule) + followers, ::quotedJson) },
    )
}

/**
 * Something that happened, as shown by findings.
 *
 * @property name the event, as the start of a sentence: “The robot pushed against something”.
 * @property shownBy the rules with findings that show it.
 * @property topics patterns for the topic of such a finding, if it matters; empty for all.
 * @property together the number of topics that must have findings at about the same time.
 * @property onlyWith rules that confirm the cause: a finding of at least one must follow. Empty if none is necessary.
 * @property next the next step.
 */
internal class Cause(
    val name: String,
    val shownBy: List<String>,
    val topics: List<NamePattern>,
    val except: List<NamePattern>,
    val together: Int,
    val onlyWith: List<String>,
    val next: String,
) {
    fun isShownBy(rule: String, topic: String?): Boolean {
        if (rule !in shownBy) return false
        if (topics.isEmpty() && except.isEmpty()) return true
        val folded = NamePattern.folded(topic.orEmpty())
        return (topics.isEmpty() || topics.any { it.matchesFolded(folded) }) && except.none { it.matchesFolded(folded) }
    }
}

private fun causeJson(cause: Cause): String = jsonObject(
    "name" to quotedJson(cause.name),
    "shownBy" to jsonArray(cause.shownBy, ::quotedJson),
    "topics" to patternsJson(cause.topics),
    "except" to patternsJson(cause.except),
    "together" to cause.together.takeIf { it > 1 }?.toString(),
    "onlyWith" to jsonList(cause.onlyWith, ::quotedJson),
    "next" to cause.next.takeIf { it.isNotEmpty() }?.let(::quotedJson),
)

private fun causeOf(value: JsonValue): Cause {
    val json = JsonFields(value.members)
    return Cause(
        name = json.string("name"),
        shownBy = json.strings("shownBy"),
        topics = json.patterns("topics"),
        except = json.patterns("except"),
        together = if (json.find("together") == null) 1 else json.number("together"),
        onlyWith = json.strings("onlyWith"),
        next = json.optional("next").orEmpty(),
    )
}

private fun effectOf(value: JsonValue): Pair<String, List<String>> {
    val names = itemsOf(value).map(::stringOf)
    return names.first() to names.drop(1)
}
