package badlog.plot.formula

import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.ViewWithVirtualTopics
import badlog.expression.VirtualTopic
import badlog.expression.signals.Vocabulary

/**
 * What a definition of a topic, such as `Power [W] = Voltage * Current`, comes to in one recording.
 *
 * @property definition it, as a person wrote it.
 * @property topic the topic; null where it makes none.
 * @property error why it makes none; null where it makes one.
 */
public class Formula(public val definition: String, public val topic: VirtualTopic?, public val error: ExpressionError?) {
    /** The full name of its topic; null where the definition does not even have that. */
    public val name: String? get() = topic?.name ?: nameIn(definition)
}

/** What each of [definitions], from which [calculated] was made, comes to, in their order. */
public fun formulasOf(definitions: List<String>, calculated: ViewWithVirtualTopics): List<Formula> {
    // From the end: of two equal definitions, the second is the one that failed.
    var error = calculated.errors.size - 1
    var topic = calculated.topics.size - 1
    return definitions.asReversed().map { definition ->
        if (error >= 0 && calculated.errors[error].text == definition) {
            Formula(definition, null, calculated.errors[error--])
        } else {
            Formula(definition, calculated.topics[topic--], null)
        }
    }.asReversed()
}

/** The name of the topic that [definition] defines, whether or not its expression means anything; null for none. */
public fun nameIn(definition: String): String? {
    // A name in quotes may hold = too.
    for (at in definition.indices) {
        if (definition[at] != '=') continue
        val topic = VirtualTopic.parse(definition.substring(0, at) + "= 0", NOTHING)
        if (topic is VirtualTopic) return topic.name
    }
    return null
}

/** [definitions] with those of [others], which take the place of those of the same names. */
public fun joined(definitions: List<String>, others: List<String>): List<String> {
    val names = others.mapNotNullTo(HashSet(), ::nameIn)
    return (definitions.filter { it in others || nameIn(it) !in names } + others).distinct()
}

/** [name] as an expression over [vocabulary] may call it: in quotes where it needs them. */
public fun nameInExpression(name: String, vocabulary: Vocabulary): String {
    val alone = Expression.parse("changed($name)", vocabulary)
    val isPlain = alone is Expression && alone.topics == listOf(name)
    return if (isPlain) name else "\"${name.replace("\"", "\"\"")}\""
}

private val NOTHING = Vocabulary(emptyList())
