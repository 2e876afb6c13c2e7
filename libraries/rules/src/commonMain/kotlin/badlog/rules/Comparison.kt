package badlog.rules

/**
 * What a rule compares with the team's other logs, instead of asking a condition.
 *
 * @property signals the signals of whose topics the figures are compared.
 * @property deviations how far a figure has to be from the median of the others, in their usual distances from it.
 * @property percent how far it has to be from it at least, in percent of it.
 * @property findings so many figures of a log are findings, the farthest.
 * @property others how many other logs have to have the figure.
 */
internal class Comparison(val signals: List<String>, val deviations: Double, val percent: Double, val findings: Int, val others: Int) {
    companion object {
        /** Of fewer nobody knows how far they usually are from each other. */
        const val FEWEST_OTHERS = 5

        /** The limits of a rule that compares, all of which it has. */
        val LIMITS = listOf("deviations", "percent", "findings", "others")
    }
}
