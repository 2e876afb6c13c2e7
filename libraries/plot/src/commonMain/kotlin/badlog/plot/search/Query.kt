package badlog.plot.search

/**
 * What a person searches for, in capitals or not:
 *
 * - words, of which each has to occur, in any order; words in quotes occur together, as they stand;
 * - `a | b` finds what has one or the other;
 * - `-c` leaves out what has it;
 * - `is:` and `has:` ask for what the topic is, see [Trait]; with another word behind the colon they are words like others.
 *
 * What is being typed finds what it did before: a sign without a word, and an alternative without one, ask for nothing.
 */
public class Query(text: String) {
    private class Term(val isWanted: Boolean, val word: String, val trait: Trait?)

    private val alternatives: List<List<Term>> = tokensOf(text.lowercase()).let { tokens ->
        val parts = ArrayList<ArrayList<Term>>().apply { add(ArrayList()) }
        for (token in tokens) if (token == null) parts.add(ArrayList()) else parts.last().add(token)
        parts.filter { it.isNotEmpty() }
    }

    /** The words that are to occur, in lower case, to be marked where they do. */
    public val words: List<String> = alternatives.flatten().filter { it.isWanted && it.trait == null }.map { it.word }

    /** Whether nothing is searched for, so that everything is shown. */
    public val isEmpty: Boolean get() = alternatives.isEmpty()

    /** Whether it finds [text] of something that is all of [traits]. */
    public fun matches(text: String, traits: Set<Trait> = emptySet()): Boolean = isEmpty || matchesLowercase(text.lowercase(), traits)

    /** The same for a text that is in lower case already, as what is searched on each key should be. */
    public fun matchesLowercase(text: String, traits: Set<Trait> = emptySet()): Boolean {
        if (isEmpty) return true
        for (terms in alternatives) {
            if (terms.all { (if (it.trait == null) it.word in text else it.trait in traits) == it.isWanted }) return true
        }
        return false
    }

    /** Whether it asks for [trait], so that it has to be known. */
    public fun asksFor(trait: Trait): Boolean = alternatives.any { terms -> terms.any { it.trait == trait } }

    private companion object {
        private fun isBlank(char: Char) = char == ' ' || char == '\t'

        /** The terms of [text], in lower case; null is a bar between alternatives. */
        fun tokensOf(text: String): List<Term?> {
            val tokens = ArrayList<Term?>()
            var at = 0
            while (at < text.length) {
                val char = text[at]
                if (isBlank(char)) {
                    at++
                } else if (char == '|') {
                    tokens += null
                    at++
                } else {
                    val isWanted = char != '-'
                    if (!isWanted) at++
                    val isQuoted = at < text.length && text[at] == '"'
                    val start = if (isQuoted) at + 1 else at
                    at = start
                    while (at < text.length && if (isQuoted) text[at] != '"' else !isBlank(text[at]) && text[at] != '|') at++
                    val word = text.substring(start, at)
                    if (isQuoted) at++
                    if (word.isNotEmpty()) tokens += Term(isWanted, word, if (isQuoted) null else Trait.of(word))
                }
            }
            return tokens
        }
    }
}
