package badlog.charts.match

/**
 * Returns a short, unique name for each of [topics]. Whole words at the beginning or end that all topics share are omitted.
 * `/Drive/LeftTemp` and `/Arm/Temp` become `Drive/Left` and `Arm`.
 */
internal fun distinctNames(topics: List<String>): List<String> {
    val taken = HashSet<String>()
    val begin = if (topics.size < 2) "" else topics.reduce { one, other -> one.commonPrefixWith(other) }
    val end = if (topics.size < 2) "" else topics.reduce { one, other -> one.commonSuffixWith(other) }
    val (before, after) = begin.dropLastWhile { it !in SEPARATORS } to end.dropWhile { !it.isUpperCase() && it !in SEPARATORS }
    return topics.map { topic ->
        val own = topic.removePrefix(before).removeSuffix(after).trim(*SEPARATORS)
        val name = plainText(own.ifEmpty { topic.trim(*SEPARATORS) }, MAX_NAME).ifEmpty { "motor" }
        generateSequence(1) { it + 1 }.map { if (it == 1) name else "$name ($it)" }.first(taken::add)
    }
}

private val SEPARATORS = charArrayOf('/', ' ', '_', '.', ':')

/** The maximum length of a name in a legend. */
private const val MAX_NAME = 22
