package badlog.viewer.choices

/**
 * The content of a file to which lines are appended, one per change.
 *
 * @property changes the changes, in the order of the lines.
 * @property unreadable the line numbers, from 1 on, of lines that are damaged, or that only a newer badlog understands. They stay in the
 *   file.
 */
class AppendedLines<out C : Any>(val changes: List<C>, val unreadable: List<Int>) {
    /** Returns the [unreadable] lines of the file [name] as a sentence; null if there are none. */
    fun problemOf(name: String): String? = when (unreadable.size) {
        0 -> null

        1 -> "Line ${unreadable[0]} of $name is skipped: it is damaged, or from a newer badlog. It stays in the file."

        else ->
            "${unreadable.size} lines of $name are skipped, from line ${unreadable[0]} on: they are damaged, or from a newer badlog. " +
                "They stay in the file."
    }

    companion object {
        /**
         * Returns the content of [text]; [changeOf] reads a line, and returns null for an unreadable one. Empty lines are ignored. So is
         * an unreadable last line without a line break: a folder that is being synced may have only its beginning.
         */
        fun <C : Any> of(text: String, changeOf: (String) -> C?): AppendedLines<C> {
            val changes = ArrayList<C>()
            val unreadable = ArrayList<Int>()
            val lines = text.split('\n')
            lines.forEachIndexed { i, line ->
                if (line.isBlank()) return@forEachIndexed
                val change = changeOf(line)
                if (change != null) {
                    changes += change
                } else if (i < lines.lastIndex) {
                    unreadable += i + 1
                }
            }
            return AppendedLines(changes, unreadable)
        }
    }
}
