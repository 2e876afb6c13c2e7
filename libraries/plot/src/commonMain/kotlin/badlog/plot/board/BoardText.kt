package badlog.plot.board

import badlog.analysis.Span

/**
 * A board as the shortest text that any address takes: letters, digits and `-_./:;,=+~` alone. Graphs are parted by `;`, the lines of
 * one by `,`; then come, each behind a `,` and a letter with `=`, the title where it is not the first line's name, and what was
 * chosen besides: `Arm/Angle,Arm/Goal,t=Arm,f=,y=0:90;Mode`. In names `+` is a space, and `~` with four hexadecimal digits is any
 * other character; a line without a name is `~` alone.
 */
public fun Board.toText(): String = graphs.joinToString(";") { graph ->
    buildString {
        graph.lines.forEachIndexed { i, line ->
            if (i > 0) append(',')
            if (line.isEmpty()) append('~') else appendName(line)
        }
        if (graph.title != graph.lines.firstOrNull()) {
            append(",t=")
            appendName(graph.title)
        }
        if (graph.isFilled) append(",f=")
        if (graph.includesZero) append(",z=")
        graph.yRange?.takeIf(::isWritable)?.let { append(",y=").append(numberOf(it.from)).append(':').append(numberOf(it.to)) }
        graph.height?.let { append(",h=").append(it) }
    }
}

/**
 * The board that [text] is, see [toText].
 *
 * @throws BoardException when it is none.
 */
public fun boardOfText(text: String): Board {
    if (text.isEmpty()) return Board()
    return Board(text.split(';').mapIndexed { i, part -> graphOf(i + 1, part) })
}

private fun graphOf(id: Int, text: String): BoardGraph {
    var graph = BoardGraph(id, "", emptyList())
    val lines = LinkedHashSet<String>()
    var title: String? = null
    val parts = if (text.isEmpty()) emptyList() else text.split(',')
    for (part in parts) {
        if (part.length >= 2 && part[1] == '=') {
            val value = part.substring(2)
            when (part[0]) {
                't' -> title = nameOf(value)
                'f' -> graph = graph.copy(isFilled = true)
                'z' -> graph = graph.copy(includesZero = true)
                'y' -> graph = graph.copy(yRange = spanOf(value))
                'h' -> graph = graph.copy(height = heightOf(value))
                else -> throw BoardException("Graph $id has “${part[0]}”, which this badlog does not know; update it to open this.")
            }
        } else if (part.isNotEmpty()) {
            lines += if (part == "~") "" else nameOf(part)
        }
    }
    return graph.copy(title = title ?: lines.firstOrNull().orEmpty(), lines = lines.toList())
}

private fun StringBuilder.appendName(name: String) {
    for (char in name) {
        when {
            char in 'a'..'z' || char in 'A'..'Z' || char in '0'..'9' || char in PLAIN -> append(char)
            char == ' ' -> append('+')
            else -> append('~').append(char.code.toString(16).padStart(4, '0'))
        }
    }
}

private fun nameOf(text: String): String = buildString {
    var at = 0
    while (at < text.length) {
        val char = text[at++]
        when (char) {
            '+' -> append(' ')

            '~' -> {
                val digits = text.substring(at, minOf(at + 4, text.length))
                if (digits.length < 4 || digits.any { it !in '0'..'9' && it !in 'a'..'f' && it !in 'A'..'F' }) {
                    throw BoardException("“~$digits” is not a character; copy the whole address again.")
                }
                append(digits.toInt(16).toChar())
                at += 4
            }

            else -> append(char)
        }
    }
}

private fun numberOf(value: Double) = value.toString().replace("+", "")

private fun spanOf(text: String): Span {
    val from = text.substringBefore(':').toDoubleOrNull()
    val to = text.substringAfter(':', "").toDoubleOrNull()
    if (from == null || to == null || !isWritable(Span(from, to))) {
        throw BoardException("“$text” is not a range of y; copy the whole address again.")
    }
    return Span(from, to)
}

private fun heightOf(text: String): Int =
    text.toIntOrNull()?.coerceIn(BoardGraph.HEIGHTS) ?: throw BoardException("“$text” is not a height; copy the whole address again.")

/** Whether [range] is one that can be written: JSON has no numbers that are not finite. */
internal fun isWritable(range: Span): Boolean = range.from < range.to && range.from.isFinite() && range.to.isFinite()

private const val PLAIN = "-_./"
