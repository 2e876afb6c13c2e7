package badlog.samples.generated.fault

/**
 * A phrase to look for in a program's text about a match. All of its words must occur, in any order, each as the start of a word, or as a
 * whole word if it has fewer than four letters. `|` separates alternatives of a word: `battery old|weak` finds “The battery is weaker than
 * usual”, and `can wire` does not find “The wires cannot be seen”.
 */
class Phrase(private val text: String) {
    private val words = text.lowercase().split(' ').map { it.split('|') }

    /** Returns whether [sentence] contains the phrase; letter case is ignored. */
    fun isIn(sentence: String): Boolean {
        val found = sentence.lowercase().split(NO_WORD)
        return words.all { alternatives -> alternatives.any { start -> found.any { begins(it, start) } } }
    }

    private fun begins(word: String, start: String) = if (start.length < 4) word == start else word.startsWith(start)

    override fun toString(): String = text

    private companion object {
        val NO_WORD = Regex("[^a-z0-9]+")
    }
}

/** The verdict on a sentence about the cause of a fault. */
enum class Verdict { CAUSE, SYMPTOM, OTHER }
