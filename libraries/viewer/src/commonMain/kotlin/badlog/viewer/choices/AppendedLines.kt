package badlog.viewer.choices

/**
 * The content of a file to which lines are appended, one per change.
 *
 * @property changes its changes, in the order of its lines.
 * @property unreadable the numbers of the lines that are damaged, or that only a newer badlog understands, from 1 on. They stay in the file.
 */
class AppendedLines<out C : Any>(val changes: List<C>, val unreadable: List<Int>) {
    /** Returns the [unreadable] lines of the file [name] as a sentence; null if there are none. */
    fun problemOf(name: String): String? = when (unreadable.size) {
        0 -> null

        1 -> "Line ${unreadable[0]} of $name is skipped: it is damaged, or of a newer badlog. It stays in the file."

        else ->
            "${unreadable.size} lines of $name are skipped, the first is line ${unreadable[0]}: they are damaged, or of a newer badlog. " +
                "They stay in the file."
    }

    companion object {
        /**
         * Returns the content of [text], whose lines [changeOf] reads. Empty lines are ignored, and so is a last one that is not ended: a folder
         * that is being synced may have only the beginning of it.
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
