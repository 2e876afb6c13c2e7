package badlog.rules.number

import badlog.signals.match.MatchKind

/**
 * [LogNumbers] as texts: logs of one robot usually share [names], which are then parsed only once.
 *
 * @property names the keys of the numbers, one per line.
 * @property values the numbers in the order of [names].
 * @property distributions the distributions, one per line.
 */
class LogNumbersText(val names: String, val values: String, val distributions: String = "")

/** Returns these numbers as texts. */
fun LogNumbers.toText(): LogNumbersText = LogNumbersText(
    keys.joinToString("\n") { listOf(it.signal, it.topic, it.measure.ordinal, it.unit).joinToString("\t") },
    listOf(kind.ordinal, uncertainty, beginsEnabled, endsEnabled).joinToString(";", postfix = ";") + values.joinToString(";"),
    distributions.joinToString("\n") { one ->
        listOf(one.signal, one.unit, one.quantiles.joinToString(";"), one.binWidth, secondsText(one.seconds)).joinToString("\t")
    },
)

/** Most bins are empty, so that a run of them is written as `n*`. */
private fun secondsText(seconds: List<Double>): String {
    val parts = ArrayList<String>()
    var empty = 0
    for (second in seconds) {
        if (second == 0.0) {
            empty++
            continue
        }
        if (empty > 0) parts += "$empty*"
        empty = 0
        parts += "$second"
    }
    if (empty > 0) parts += "$empty*"
    return parts.joinToString(";")
}

private fun secondsIn(text: String): List<Double>? {
    val seconds = ArrayList<Double>()
    for (part in text.split(';').filter { it.isNotEmpty() }) {
        val empty = if (part.endsWith('*')) part.dropLast(1).toIntOrNull()?.takeIf { it in 1..MAX_BINS } ?: return null else 0
        if (empty > 0) repeat(empty) { seconds += 0.0 } else seconds += part.toDoubleOrNull() ?: return null
    }
    return seconds
}

private const val MAX_BINS = 1000

/** Reads the texts of [toText]; equal texts of names are parsed once. Not thread-safe. */
class LogNumbersReader {
    private val keys = HashMap<String, List<NumberKey>>()

    /** Returns the numbers in [text]; none if it is not a text of numbers. */
    fun read(text: LogNumbersText): LogNumbers {
        val keys = keys.getOrPut(text.names) { keysOf(text.names) }
        val parts = text.values.split(';')
        // A list of no values is one empty text.
        if (parts.size != maxOf(1, keys.size) + FIRST) return LogNumbers.NONE
        val kind = MatchKind.entries.getOrNull(parts[0].toIntOrNull() ?: -1) ?: return LogNumbers.NONE
        return LogNumbers(
            kind,
            keys,
            DoubleArray(keys.size) { parts[it + FIRST].toDoubleOrNull() ?: Double.NaN },
            parts[1].toDoubleOrNull() ?: Double.NaN,
            beginsEnabled = parts[2] == "true",
            endsEnabled = parts[3] == "true",
            distributions = text.distributions.split('\n').mapNotNull(::distributionIn),
        )
    }

    private fun distributionIn(line: String): Distribution? {
        val parts = line.split('\t')
        if (parts.size != DISTRIBUTION_PARTS) return null
        val quantiles = parts[2].split(';').mapNotNull { it.toDoubleOrNull() }
        if (quantiles.size != Distribution.SHARES.size) return null
        return Distribution(parts[0], parts[1], quantiles, parts[3].toDoubleOrNull() ?: return null, secondsIn(parts[4]) ?: return null)
    }

    private fun keysOf(names: String): List<NumberKey> = if (names.isEmpty()) {
        emptyList()
    } else {
        names.split('\n').map { line ->
            val parts = line.split('\t')
            if (parts.size != PARTS) return emptyList()
            NumberKey(parts[0], parts[1], Measure.entries.getOrNull(parts[2].toIntOrNull() ?: -1) ?: return emptyList(), parts[3])
        }
    }
}

private const val PARTS = 4
private const val DISTRIBUTION_PARTS = 5

/** The index of the first value. */
private const val FIRST = 4
