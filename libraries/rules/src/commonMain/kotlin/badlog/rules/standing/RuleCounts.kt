package badlog.rules.standing

/**
 * Counts of a rule's findings in the logs of [set].
 *
 * @property rule its name.
 * @property hash the beginning of the hash of the rule's text; if it differs, the counts are of another text.
 * @property couldRun the number of logs in which it could run.
 * @property teams the number of teams with these logs; 0 for simulations.
 * @property fired the number of its findings.
 * @property right the number of true ones: facts that the team would accept as worth a warning.
 * @property wrong the number of false ones.
 * @property unknown the number of findings that cannot be judged, since the log does not show enough.
 */
data class RuleCounts(
    val rule: String,
    val hash: String,
    val set: EvidenceSet,
    val couldRun: Int,
    val teams: Int,
    val fired: Int,
    val right: Int,
    val wrong: Int,
    val unknown: Int,
) {
    /** The number of findings that were not judged yet. */
    val unjudged: Int get() = fired - right - wrong - unknown
}

/**
 * Returns the counts in [text], which has a row for each rule and set with tabs between its cells. Lines that begin with `#` are remarks.
 *
 * @throws IllegalArgumentException if a row is malformed; the message has its line.
 */
fun ruleCountsIn(text: String): List<RuleCounts> =
    text.lines().withIndex().filter { (_, line) -> line.isNotBlank() && !line.startsWith("#") }
        .map { (at, line) ->
            val cells = line.split('\t')
            val set = EvidenceSet.entries.find { it.id == cells.getOrNull(SET) }
            val numbers = cells.drop(SET + 1).map { it.toIntOrNull() ?: -1 }
            require(set != null && numbers.size == NUMBERS && numbers.all { it >= 0 }) {
                "Line ${at + 1} of the counts is not a rule, a hash, a set and $NUMBERS numbers with tabs between them; make the table again."
            }
            RuleCounts(cells[0], cells[1], set, numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5])
        }

/** Returns [counts] as the text of a table that [ruleCountsIn] reads. */
fun textOf(counts: List<RuleCounts>): String = counts.joinToString("", "# ${COLUMNS.joinToString("\t")}\n") { row ->
    val numbers = row.run { listOf(couldRun, teams, fired, right, wrong, unknown) }
    (listOf(row.rule, row.hash, row.set.id) + numbers).joinToString("\t", postfix = "\n")
}

private val COLUMNS = listOf("rule", "hash", "set", "could run", "teams", "fired", "true", "false", "unknown")
private const val SET = 2
private const val NUMBERS = 6
