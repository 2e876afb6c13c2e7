package badlog.viewer.formula

import badlog.expression.Vocabulary
import badlog.viewer.text.wordsOf

/**
 * The names that may be meant where a person types.
 *
 * @property from where what they would replace begins.
 * @property until where it ends.
 * @property names full names, the likeliest first.
 */
internal class Suggestions(val from: Int, val until: Int, val names: List<String>) {
    companion object {
        /** Those for the definition [text] with the text cursor at [cursor]; none while its own name is typed. */
        fun of(text: String, cursor: Int, vocabulary: Vocabulary): Suggestions {
            val equals = text.indexOf('=')
            if (equals < 0 || cursor <= equals) return Suggestions(cursor, cursor, emptyList())
            val typed = text.substring(equals + 1, cursor)
            val begins = BREAKS.findAll(typed).map { it.range.last + 1 }.lastOrNull() ?: 0
            // A name may have blanks: all that may belong to it is tried first, then the last word alone.
            val starts = listOf(begins, typed.lastIndexOf(' ') + 1).distinct()
            for (start in starts) {
                val fragment = typed.substring(start)
                val words = wordsOf(fragment.trim('"', '`'))
                if (words.isEmpty()) continue
                val from = equals + 1 + start + (fragment.length - fragment.trimStart().length)
                val found = namesWith(words, vocabulary)
                val isWhole = found.size == 1 && found[0] == text.substring(from, cursor)
                if (found.isNotEmpty()) return Suggestions(from, cursor, if (isWhole) emptyList() else found)
            }
            return Suggestions(cursor, cursor, emptyList())
        }

        private fun namesWith(words: List<String>, vocabulary: Vocabulary): List<String> = vocabulary.signals.asSequence()
            .map { it.name }
            .filter { name -> words.all { name.contains(it, ignoreCase = true) } }
            .sortedBy { name -> if (name.substringAfterLast('/').startsWith(words[0], ignoreCase = true)) 0 else 1 }
            .take(MOST)
            .toList()

        /** What cannot be within a name that is still typed, or hardly is. */
        private val BREAKS = Regex("""[+*(,<>=!&|^%]| [-/] |\b(and|or|not|when|for|contains|matches) """)
        private const val MOST = 8
    }
}
