package badlog.rules.number

/**
 * [LogFigures] as two texts: logs of one robot usually share [names], which are then parsed only once.
 *
 * @property names what is measured.
 * @property values the figures in the order of [names].
 */
class FigureText(val names: String, val values: String)

/** These figures as text. */
fun LogFigures.toText(): FigureText = FigureText(
    keys.joinToString("\n") { listOf(it.signal, it.topic, it.measure.ordinal, it.unit).joinToString("\t") },
    listOf(kind.ordinal, uncertainty, beginsEnabled, endsEnabled).joinToString(";", postfix = ";") + values.joinToString(";"),
)

/** Reads what [toText] wrote; equal texts of names are parsed once. Not thread-safe. */
class FigureReader {
    private val keys = HashMap<String, List<FigureKey>>()

    /** Returns the figures in [text]; none if it is not a text of figures. */
    fun read(text: FigureText): LogFigures {
        val keys = keys.getOrPut(text.names) { keysOf(text.names) }
        val parts = text.values.split(';')
        // A list of no values is one empty text.
        if (parts.size != maxOf(1, keys.size) + FIRST) return LogFigures.NONE
        val kind = MatchKind.entries.getOrNull(parts[0].toIntOrNull() ?: -1) ?: return LogFigures.NONE
        return LogFigures(
            kind,
            keys,
            DoubleArray(keys.size) { parts[it + FIRST].toDoubleOrNull() ?: Double.NaN },
            parts[1].toDoubleOrNull() ?: Double.NaN,
            beginsEnabled = parts[2] == "true",
            endsEnabled = parts[3] == "true",
        )
    }

    private fun keysOf(names: String): List<FigureKey> = if (names.isEmpty()) {
        emptyList()
    } else {
        names.split('\n').map { line ->
            val parts = line.split('\t')
            if (parts.size != PARTS) return emptyList()
            FigureKey(parts[0], parts[1], Measure.entries.getOrNull(parts[2].toIntOrNull() ?: -1) ?: return emptyList(), parts[3])
        }
    }

    private companion object {
        const val PARTS = 4

        /** Where the values begin. */
        const val FIRST = 4
    }
}
