package badlog.viewer.recording

import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.expression.VirtualTopic
import badlog.expression.signals.Vocabulary

/**
 * What a definition of a topic, such as `Power [W] = Voltage * Current`, comes to in one recording.
 *
 * @property definition it, as a person wrote it.
 * @property topic the topic; null where it makes none.
 * @property error why it makes none; null where it makes one.
 */
internal class Formula(val definition: String, val topic: VirtualTopic?, val error: ExpressionError?) {
    /** The full name of its topic; null where the definition does not even tell that. */
    val name: String? get() = topic?.name ?: nameIn(definition)
}

/** The name of the topic that [definition] defines, whether or not its expression means anything; null for none. */
internal fun nameIn(definition: String): String? = definition.indices.asSequence()
    // A name in quotes may hold = too.
    .filter { definition[it] == '=' }
    .map { VirtualTopic.parse(definition.substring(0, it) + "= 0", NOTHING) }
    .filterIsInstance<VirtualTopic>()
    .firstOrNull()?.name

/** [definitions] with those of [others], which take the place of those of the same names. */
internal fun joined(definitions: List<String>, others: List<String>): List<String> {
    val names = others.mapNotNullTo(HashSet(), ::nameIn)
    return (definitions.filter { it in others || nameIn(it) !in names } + others).distinct()
}

/** [name] as an expression over [vocabulary] may call it: in quotes where it needs them. */
internal fun nameInExpression(name: String, vocabulary: Vocabulary): String {
    val alone = Expression.parse("changed($name)", vocabulary)
    val isPlain = alone is Expression && alone.topics == listOf(name)
    return if (isPlain) name else "\"${name.replace("\"", "\"\"")}\""
}

private val NOTHING = Vocabulary(emptyList())
