package badlog.architecture.english

/**
 * A kind of phrase that a technical editor would question. Most of these are translated clauses that a noun expresses better.
 *
 * @property instead the advice for rewriting it.
 */
internal enum class Phrase(val instead: String, pattern: String) {
    WHAT_CLAUSE(
        "name the thing",
        "what (?:an?|the|this|its?|they|he|she|you|people|(?:some|no|any)body|" +
            "is|are|was|were|has|have|had|can|may|must|comes|came|goes)",
    ),
    OF_WHICH("start a new sentence", "of which"),
    WHOSE("use “with” or a possessive", "whose"),
    THAT_OF("repeat the noun", "(?:that|those) of"),
    SOMEBODY("name the person, or use the passive", "(?:some|no|any)body(?:’s|'s)?"),
    IS_NO("write “is not a”", """(?<!there\s)(?:is|are|was|were) no (?!longer|more|less|fewer|earlier|later)[a-z]+"""),
    AS_FAR_AS("write “if” or “up to”", "as far as"),
    ;

    /** Words may be on different lines of a comment. */
    private val regex = Regex("(?i)\\b(?:" + pattern.replace(" ", """\s+(?:(?:\*|//|#)\s*)?""") + ")\\b")

    /** Returns the matches of this phrase in [text], each together with it. */
    fun matchesIn(text: String): Sequence<Pair<MatchResult, Phrase>> = regex.findAll(text).map { it to this }
}

/**
 * A phrase in a file.
 *
 * @property line its line, from 1.
 * @property text its words.
 */
internal class Place(val line: Int, val text: String, val phrase: Phrase)

/** Returns all phrases found in [text], the content of the file called [name], in their order. */
internal fun placesIn(name: String, text: String): List<Place> = passagesOf(name, text).flatMap { passage ->
    Phrase.entries.flatMap { it.matchesIn(passage.text) }.sortedBy { (match, _) -> match.range.first }.map { (match, phrase) ->
        val line = passage.line + passage.text.substring(0, match.range.first).count { it == '\n' }
        Place(line, match.value.replace(BREAK, " "), phrase)
    }
}

private val BREAK = Regex("""\s*\n\s*(?:\*|//|#)?\s*""")
