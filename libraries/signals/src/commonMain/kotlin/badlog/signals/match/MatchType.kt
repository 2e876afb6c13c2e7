package badlog.signals.match

/**
 * A type of match. Robots, fields, names of files and people write the same type in different ways.
 *
 * @property title its name.
 * @property kind the kind of run.
 * @param word the part of a text that names the type, in lower case; the first type with its word in the text counts.
 * @param inNames its forms in names of files, as a regular expression; empty if it has none.
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
