package badlog.charts.match

/** Returns a label for each of [logs], such as `Q42`; no two are equal. */
internal fun labelsOf(logs: List<ChartedLog>): List<String> {
    val taken = HashSet<String>()
    return logs.map { log ->
        val label = shortName(log)
        generateSequence(1) { it + 1 }.map { if (it == 1) label else "$label ($it)" }.first(taken::add)
    }
}

private fun shortName(log: ChartedLog): String {
    val number = log.match.number?.let { plainText(it, MAX_NUMBER) }.orEmpty()
    if (number.isEmpty()) return plainText(log.file.substringBefore('.'), MAX_LABEL).ifEmpty { "log" }
    val type = log.match.type.orEmpty()
    // The letters by which The Blue Alliance and teams call matches; a practice match is not P1, which could also be a playoff.
    val letter = LETTERS.firstOrNull { (word, _) -> type.contains(word, ignoreCase = true) }?.second
    return (letter ?: "M") + number
}

/**
 * Returns [text], which comes from a file, with nothing in it that a chart could take for markup, and shortened to [max] characters. Charts are
 * drawn by a library that knows tags and formulas in texts.
 */
internal fun plainText(text: String, max: Int): String {
    val plain = text.map {
        if (it.isLetterOrDigit() ||
            it in " -_.,:+#/()'’"
        ) {
            it
        } else {
            ' '
        }
    }.joinToString("").replace(Regex(" {2,}"), " ").trim()
    return if (plain.length <= max) plain else plain.take(max - 1).trim() + "…"
}

private val LETTERS = listOf(
    "qual" to "Q",
    "quarter" to "QF",
    "semi" to "SF",
    "final" to "F",
    "elim" to "E",
    "playoff" to "E",
    "practice" to "Pr",
    "test" to "T",
)

/** Sets of a playoff, such as 2-1, are short. */
private const val MAX_NUMBER = 6
private const val MAX_LABEL = 14
