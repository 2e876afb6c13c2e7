package badlog.signals.match

/**
 * A type of match. Robots, fields, names of files and people write the same type in different ways.
 *
 * @property title its name.
 * @property kind the kind of run.
 * @param word what a text that names the type contains, in lower case; the first type whose word it contains is meant.
 * @param inNames how names of files write it, as a regular expression; empty if they do not.
 */
enum class MatchType(val title: String, val kind: MatchKind, private val word: String, internal val inNames: String) {
    PRACTICE("Practice", MatchKind.PRACTICE, "prac", "practice|prac|pm|p"),
    TEST("Test", MatchKind.PRACTICE, "test", ""),
    QUALIFICATION("Qualification", MatchKind.MATCH, "qual", "qualification|qualifier|quals?|qm|q"),
    QUARTERFINAL("Quarterfinal", MatchKind.MATCH, "quarter", "quarterfinals?|qf"),
    SEMIFINAL("Semifinal", MatchKind.MATCH, "semi", "semifinals?|semis?|sf"),
    FINAL("Final", MatchKind.MATCH, "final", "finals?|f"),
    ELIMINATION("Elimination", MatchKind.MATCH, "elim", "eliminations?|elims?|e"),
    PLAYOFF("Playoff", MatchKind.MATCH, "playoff", "playoffs?"),
    ;

    companion object {
        /** Returns the type that [text] names, as a log or a person writes it; null for none of them. */
        fun of(text: String): MatchType? = entries.find { text.contains(it.word, ignoreCase = true) }
    }
}
