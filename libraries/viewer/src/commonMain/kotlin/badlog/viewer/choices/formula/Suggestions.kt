package badlog.viewer.choices.formula

import badlog.core.text.isLetterOrDigit
import badlog.expression.signals.Vocabulary

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
