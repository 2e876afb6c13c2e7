package badlog.viewer.choices.formula

import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.ViewWithVirtualTopics
import badlog.expression.VirtualTopic
import badlog.expression.signals.Vocabulary

/**
 * The result of a definition such as `Power [W] = Voltage * Current` for one recording.
 *
 * @property definition the definition, as a person wrote it.
 * @property topic the topic; null if there is an error.
 * @property error the mistake in the definition; null if there is a topic.
 */
class Formula(val definition: String, val topic: VirtualTopic?, val error: ExpressionError?) {
    /** The full name of the topic; null if the definition does not have one. */
    val name: String? get() = topic?.name ?: nameIn(definition)
}

/** Returns the result of each of [definitions], in order; [calculated] was made from them. */
fun formulasOf(definitions: List<String>, calculated: ViewWithVirtualTopics): List<Formula> {
    // Backwards: of two equal definitions, the second is the one that failed.
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

/** Returns the name of the topic that [definition] defines, even if its expression is invalid; null if there is none. */
fun nameIn(definition: String): String? {
    // A quoted name may also contain =.
    for (at in definition.indices) {
        if (definition[at] != '=') continue
        val topic = VirtualTopic.parse(definition.substring(0, at) + "= 0", NOTHING)
        if (topic is VirtualTopic) return topic.name
    }
    return null
}

/** Returns the identity of a remembered [definition]: the name of its topic. */
fun keyOf(definition: String): String = nameIn(definition) ?: definition

/** Returns [definitions] and [others]; the latter replace definitions with the same names. */
fun joined(definitions: List<String>, others: List<String>): List<String> {
    val names = others.mapNotNullTo(HashSet(), ::nameIn)
    return (definitions.filter { it in others || nameIn(it) !in names } + others).distinct()
}

/** Returns [name] as written in an expression over [vocabulary], quoted if necessary. */
fun nameInExpression(name: String, vocabulary: Vocabulary): String {
    val alone = Expression.parse("changed($name)", vocabulary)
    val isPlain = alone is Expression && alone.topics == listOf(name)
    return if (isPlain) name else "\"${name.replace("\"", "\"\"")}\""
}

private val NOTHING = Vocabulary(emptyList())
