package badlog.viewer.choices.formula

import badlog.core.text.isLetterOrDigit
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

/** Returns the definitions of the formulas that need the topic of [definition], directly or through others, in order. */
fun List<Formula>.usersOf(definition: String): List<String> {
    val needed = hashSetOf(find { it.definition == definition }?.topic?.name ?: return emptyList())
    return filter { formula ->
        val topic = formula.topic
        topic != null && topic.expression.topics.any { it in needed } && needed.add(topic.name)
    }.map { it.definition }
}

/** Returns the reason why [definition] cannot be removed, as a sentence; null if it can. */
fun List<Formula>.reasonToKeep(definition: String): String? = usersOf(definition).sentence("it; remove that first")

/** Returns the reason why [definition] cannot be replaced by [replacement] with another name, as a sentence; null if it can. */
fun List<Formula>.reasonToKeepName(definition: String, replacement: String): String? =
    if (nameIn(definition) == nameIn(replacement)) null else usersOf(definition).sentence("this name; change that first")

private fun List<String>.sentence(end: String): String? = when (size) {
    0 -> null
    1 -> "“${single()}” needs $end."
    else -> "${joinToString { "“$it”" }} need $end."
}

/**
 * The remark on a definition while a person types it.
 *
 * @property isError whether it is a mistake that more typing cannot fix; otherwise it is a hint.
 */
class TypedRemark(val text: String, val isError: Boolean)

/** Returns the remark on this mistake. A mistake at the end of the text may disappear with the next letter. */
fun ExpressionError.whileTyping(): TypedRemark = when {
    until < text.trimEnd().length -> TypedRemark(message, isError = true)
    isFunctionAlone -> TypedRemark("Type on for a name, or “(” for the function ${text.substring(from, until)}.", isError = false)
    else -> TypedRemark(message, isError = false)
}

/**
 * The names suggested while a person types a definition.
 *
 * @property from the start of the text that they would replace.
 * @property until the end of that text.
 * @property names full names, the most likely first; [nameInExpression] returns the name for a formula.
 */
class Suggestions(val from: Int, val until: Int, val names: List<String>) {
    companion object {
        /**
         * Returns the suggestions for the definition [text] with the text cursor at [cursor]. There are none while a person types the
         * topic's own name.
         */
        fun of(text: String, cursor: Int, vocabulary: Vocabulary): Suggestions {
            val equals = text.indexOf('=')
            if (equals < 0 || cursor <= equals) return Suggestions(cursor, cursor, emptyList())
            val typed = text.substring(equals + 1, cursor)
            // A name may have spaces: first all text that may belong to it is tried, then only the last word.
            for (start in listOf(lastBreak(typed), typed.lastIndexOf(' ') + 1)) {
                val begun = typed.substring(start).trimStart()
                // Unlike in a search, the signs for excluding and separating are operators here.
                val words = begun.trim('"', '`').split(' ').filter { it.isNotEmpty() }
                if (words.isEmpty()) continue
                val found = vocabulary.signals.map { it.name }.filter { name -> words.all { name.contains(it, ignoreCase = true) } }
                if (found.isEmpty()) continue
                val others = found.filterNot { it.equals(begun, ignoreCase = true) }
                return Suggestions(cursor - begun.length, cursor, others.sortedBy { rank(it, words[0]) }.take(MAX_NAMES))
            }
            return Suggestions(cursor, cursor, emptyList())
        }

        private fun rank(name: String, word: String) =
            if (name.startsWith(word, ignoreCase = true) || name.substringAfterLast('/').startsWith(word, ignoreCase = true)) 0 else 1

        /** Returns the index after the last character that hardly ever belongs to a name being typed. */
        private fun lastBreak(typed: String): Int {
            for (end in typed.length downTo 1) {
                if (typed[end - 1] in OPERATORS) return end
                if (typed[end - 1] == ' ' && WORDS.any { endsWith(typed, end - 1, it) }) return end
            }
            return 0
        }

        private fun endsWith(typed: String, until: Int, word: String): Boolean {
            val from = until - word.length
            return from >= 0 && typed.startsWith(word, from) && (from == 0 || !isLetterOrDigit(typed[from - 1]))
        }

        private const val OPERATORS = "+*(),<>=!&|^%\n"
        private val WORDS = listOf(" -", " /", "and", "or", "not", "when", "for", "contains", "matches")
        private const val MAX_NAMES = 8
    }
}
