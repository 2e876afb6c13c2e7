package badlog.page.formula

import badlog.expression.Expression
import badlog.expression.signals.Vocabulary

/**
 * The names that may be meant by what stands before the caret of a formula.
 *
 * @property from where in the formula the begun name starts.
 * @property names the names as a formula has to call them, the likeliest first.
 */
internal class NameSuggestions private constructor(val from: Int, val names: List<String>) {
    companion object {
        private const val MOST = 6
        private const val SEPARATORS = "=+*%^(),<>!&|\n"

        /** The suggestions for [text], with the caret at [caret], from the names of [vocabulary]. */
        fun of(text: String, caret: Int, vocabulary: Vocabulary): NameSuggestions {
            // The name of the new topic itself is nobody's yet.
            val equals = text.indexOf('=')
            if (equals < 0 || caret <= equals) return NameSuggestions(caret, emptyList())
            var from = caret
            while (from > equals + 1 && text[from - 1] !in SEPARATORS) from--
            while (from < caret && text[from] == ' ') from++
            val begun = text.substring(from, caret).trim('"').lowercase()
            if (begun.isBlank()) return NameSuggestions(caret, emptyList())
            val found = vocabulary.signals.map { it.name }.filter { begun in it.lowercase() && it.lowercase() != begun }
            val ordered = found.sortedBy { baseRank(it.lowercase(), begun) }.take(MOST)
            return NameSuggestions(from, ordered.map { called(it, vocabulary) })
        }

        private fun baseRank(name: String, begun: String) = when {
            name.startsWith(begun) || name.substringAfterLast('/').startsWith(begun) -> 0
            else -> 1
        }

        // In quotes only where the language would not take it for the name.
        private fun called(name: String, vocabulary: Vocabulary): String {
            val quoted = "\"" + name.replace("\"", "\"\"") + "\""
            val plain = Expression.parse(name, vocabulary)
            return if (plain is Expression && plain.toString() == quoted) name else quoted
        }
    }
}
