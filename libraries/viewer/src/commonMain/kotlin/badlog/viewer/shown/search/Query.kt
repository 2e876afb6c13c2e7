package badlog.viewer.shown.search

/**
 * A person's search, regardless of case:
 *
 * - All words must occur, in any order, also in another form or as another word for the same thing, see [SAME_WORDS]. Quoted words must
 *   occur together, exactly as written.
 * - `a | b` finds items with one or the other.
 * - `-c` excludes items with it.
 * - `is:` and `has:` search for traits of the topic, see [Trait]. With any other word after the colon they are ordinary words.
 *
 * While typing, incomplete parts are ignored: a sign without a word, and an empty alternative.
 *
 * @property text the typed text.
 */
class Query(val text: String) {
    private class Term(val isWanted: Boolean, val word: String, val trait: Trait?, val variants: List<String>) {
        fun occursIn(text: String) = word in text || variants.any { occursIn(text, it) }
    }

    private val alternatives: List<List<Term>> = tokensOf(text.lowercase()).let { tokens ->
        val parts = ArrayList<ArrayList<Term>>().apply { add(ArrayList()) }
        for (token in tokens) if (token == null) parts.add(ArrayList()) else parts.last().add(token)
        parts.filter { it.isNotEmpty() }
    }

    /** The searched words, in lower case and with their variants, for highlighting. */
    val words: List<String> = alternatives.flatten().filter { it.isWanted && it.trait == null }.flatMap { listOf(it.word) + it.variants }

    /** Whether the search is empty, so that it matches everything. */
    val isEmpty: Boolean get() = alternatives.isEmpty()

    /** Returns whether the search matches [text] of something that has all of [traits]. */
    fun matches(text: String, traits: Set<Trait> = emptySet()): Boolean = isEmpty || matchesLowercase(text.lowercase(), traits)

    /** Returns whether the search matches [text], which is already in lower case. Texts for a search on each keystroke should be. */
    fun matchesLowercase(text: String, traits: Set<Trait> = emptySet()): Boolean {
        if (isEmpty) return true
        for (terms in alternatives) {
            if (terms.all { (if (it.trait == null) it.occursIn(text) else it.trait in traits) == it.isWanted }) return true
        }
        return false
    }

    /** Returns whether the search uses [trait], which then must be known. */
    fun asksFor(trait: Trait): Boolean = alternatives.any { terms -> terms.any { it.trait == trait } }

    private companion object {
        private fun isBlank(char: Char) = char == ' ' || char == '\t'

        /** Returns the terms of [text], which is in lower case; null for a bar between alternatives. */
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
                    val trait = if (isQuoted) null else Trait.of(word)
                    val variants = if (isQuoted || trait != null) emptyList() else variantsOf(word)
                    if (word.isNotEmpty()) tokens += Term(isWanted, word, trait, variants)
                }
            }
            return tokens
        }
    }
}

/** Words for the same thing: a search for one of them also finds the others. The glossary lists them. */
val SAME_WORDS: List<List<String>> = listOf(
    listOf("brownout", "browned out", "brown out"),
    listOf("autonomous", "auto"),
    listOf("power distribution", "powerdistribution", "pdp", "pdh"),
    listOf("setpoint", "target", "goal", "desired", "reference"),
    listOf("gyro", "imu", "navx", "pigeon"),
    listOf("temperature", "temp"),
    listOf("radio", "wireless", "wifi"),
)

/** Returns the further texts that a search for [word], in lower case, finds. They are other words for the same thing, and its stem. */
internal fun variantsOf(word: String): List<String> {
    val stem = stemOf(word)
    return (SAME_WORDS.filter { word in it || stem in it }.flatten() + stem).distinct() - word
}

/**
 * Returns whether [variant] of a word occurs in [text]. Short variants count only where a word begins: a search for `heading` finds
 * `Head Angle`, but not `overhead`.
 */
internal fun occursIn(text: String, variant: String): Boolean {
    var at = text.indexOf(variant)
    while (at > 0 && variant.length < LONG && text[at - 1] in 'a'..'z') at = text.indexOf(variant, at + 1)
    return at >= 0
}

/** Returns [word] without the ending of a plural or of a verb, if enough of it remains. */
private fun stemOf(word: String): String {
    if (word.any { it !in 'a'..'z' } || OTHER_ENDINGS.any { word.endsWith(it) }) return word
    val ending = ENDINGS.firstOrNull { word.endsWith(it) && word.length >= it.length + SHORTEST } ?: return word
    val stem = word.dropLast(ending.length)
    // As in slipping, but not in stalling and missed.
    val isDoubled = stem.length > SHORTEST && ending != "s" && stem.last() == stem[stem.length - 2] && stem.last() !in "aeioulsz"
    return if (isDoubled) stem.dropLast(1) else stem
}

private val ENDINGS = listOf("ing", "ed", "es", "s")

/** Endings that are neither of plurals nor of verbs: a bus, a loss, a speed. */
private val OTHER_ENDINGS = listOf("us", "ss", "is", "eed")
private const val SHORTEST = 4
private const val LONG = 5

/**
 * A property of a topic that a search can use besides the name.
 *
 * @property word the word for it in a search.
 */
enum class Trait(val word: String) {
    /** The values are states, or true and false. */
    STATE("is:state"),

    /** The values are numbers. */
    NUMBER("is:number"),

    /** The values are texts about what happened. */
    EVENT("is:event"),

    /** The topic never changes. */
    CONSTANT("is:constant"),

    /** The topic has no logged values. */
    EMPTY("is:empty"),

    /** A finding is about the topic. */
    FINDING("has:finding"),
    ;

    companion object {
        private val BY_WORD = entries.associateBy { it.word }

        /** Returns the trait that [word], in lower case, stands for; null for an ordinary word. */
        fun of(word: String): Trait? = BY_WORD[word]
    }
}
