package badlog.core.bag

import badlog.core.text.COMMA
import badlog.core.text.CR
import badlog.core.text.LF
import badlog.core.text.QUOTE
import badlog.core.text.TAB
import badlog.core.text.microsOfIsoTime

/** Finds the [CsvDialect] of a file by counting the cells of its first lines. One line alone may be read in several ways. */
internal object DialectSearch {
    /** The number of bytes to examine. */
    const val BYTES = 1 shl 16
    private const val MAX_LINES = 400
    private const val SEMICOLON = ';'.code

    private class Cell(val text: String) {
        val number by lazy(LazyThreadSafetyMode.NONE) { CsvNumber.of(text) }
        val isEmpty get() = text.isBlank()
        val isValue get() = number?.isPossible == true || text.trim().lowercase() in WORDS || microsOfIsoTime(text.trim()) != null
    }

    /** The lines, split at [separator]. */
    private class Reading(val separator: Int, val lines: List<List<Cell>>) {
        val width = lines.drop(1).groupingBy { it.size }.eachCount().maxByOrNull { it.value * MAX_CELLS + it.key }?.key ?: 0
        val rows = lines.drop(1).filter { it.size == width }

        /** The quality of this reading: in rows with a value, each value counts for it, each other text against it. */
        val score by lazy(LazyThreadSafetyMode.NONE) {
            if (width < 2) 0 else rows.filter { row -> row.any { it.isValue } }.sumOf(::scoreOf)
        }

        private fun scoreOf(row: List<Cell>) = row.count { it.isValue } - row.count { !it.isValue && !it.isEmpty }
    }

    /** Returns the dialect of a file that begins with the bytes from [from] until [until]. [isEnd] says whether they are the whole file. */
    fun of(bytes: ByteArray, from: Int, until: Int, isEnd: Boolean): CsvDialect {
        val all = linesOf(bytes, from, until, isEnd)
        val named = all.firstOrNull()?.let(::separatorIn)
        val lines = if (named == null) all else all.drop(1)
        if (lines.size < 2) return CsvDialect(named ?: COMMA, isNamed = named != null)
        val reading = if (named != null) Reading(named, lines.map { split(it, named) }) else likely(lines)
        return dialect(reading, named != null)
    }

    private fun likely(lines: List<String>): Reading {
        val usual = Reading(COMMA, lines.map { split(it, COMMA) })
        if (isOneColumn(usual, lines)) return Reading(SEMICOLON, lines.map { listOf(Cell(it)) })
        val others = listOf(SEMICOLON, TAB).filter { lines[0].indexOf(it.toChar()) >= 0 || lines[1].indexOf(it.toChar()) >= 0 }
            .map { separator -> Reading(separator, lines.map { split(it, separator) }) }
            // A cell between commas may contain a list, unlike its title.
            .filter { it.lines[0].size == it.width }
        return others.maxByOrNull { it.score }?.takeIf { it.score > maxOf(usual.score, 0) } ?: usual
    }

    /** Returns whether each line is one number with a decimal comma, below one title. */
    private fun isOneColumn(usual: Reading, lines: List<String>): Boolean = usual.lines[0].size == 1 && usual.width == 2 &&
        lines.size > 2 && lines.drop(1).all { line -> line.count { it == ',' } == 1 && CsvNumber.of(line)?.isPossible == true }

    private fun dialect(reading: Reading, isNamed: Boolean): CsvDialect {
        val first = reading.lines[0]
        val hasTitles = first.any { !it.isEmpty && !it.isValue }
        // A row of units has no values.
        val rows = if (hasTitles) reading.rows.run { drop(if (size > 2 && isUnits(this)) 1 else 0) } else reading.rows
        val body = if (hasTitles || first.size != reading.width) rows else rows + listOf(first)
        val isUsual = reading.separator == COMMA
        // Without such a mark, points are decimal ones between commas.
        val marked = if (isUsual && body.none { row -> row.any { cell -> cell.text.any { it in MARKS } } }) emptyList() else body.flatten()
        val numbers = marked.mapNotNull { it.number }
        fun points(mark: Char) = numbers.count { it.point == mark }

        // One such cell among others is rather a text, such as the numbers of two teams.
        fun isUsed(mark: Char) = (0 until reading.width).any { index ->
            val cells = body.mapNotNull { it.getOrNull(index) }.filter { !it.isEmpty }
            val grouped = cells.mapNotNull { it.number }.filter { it.grouping == mark || it.openMark == mark }
            (grouped.size > 1 || grouped.any { it.isSurelyGrouped }) && cells.all { it.number?.isPossible == true }
        }
        fun isBetween(mark: Char) = isUsed(mark) && numbers.any { it.grouping == mark }
        fun isOpen(mark: Char) = isUsed(mark) && numbers.any { it.openMark == mark }
        val between = when {
            !isUsual && points('.') == 0 && (isBetween('.') || (isOpen('.') && points(',') > 0)) -> '.'
            points(',') == 0 && (isBetween(',') || (isOpen(',') && points('.') > 0)) -> ','
            isBetween(' ') -> ' '
            isBetween('\'') -> '\''
            else -> null
        }
        // In quotes, between commas, the reader of rows finds decimal commas, and reports them for each topic.
        val hasComma = between != ',' && (if (isUsual) between != null && points(',') > 0 else points(',') > 0 || isOpen(','))
        val clocks = (0 until reading.width).mapNotNull { index -> clockOf(index, first, body)?.let { index to it } }.toMap()
        // If there already is a time, a clock beside it is not the x axis.
        val hasTime = (0 until reading.width).any { index -> index !in clocks && isTime(index, first, body) }
        return CsvDialect(reading.separator, hasComma, between, if (hasTime) emptyMap() else clocks, hasTitles, isNamed)
    }

    private fun isUnits(rows: List<List<Cell>>) = rows[0].none { it.isValue } && rows.drop(1).all { row -> row.any { it.isValue } }

    private fun isTime(index: Int, titles: List<Cell>, rows: List<List<Cell>>): Boolean =
        "time" in titles.getOrNull(index)?.text.orEmpty().lowercase() &&
            rows.all { it[index].isEmpty || it[index].number?.isPossible == true }

    private fun clockOf(index: Int, titles: List<Cell>, rows: List<List<Cell>>): Double? {
        val cells = rows.map { it[index] }.filter { !it.isEmpty }
        if (cells.size < 2) return null
        val times = cells.mapNotNull { microsOfIsoTime(it.text.trim()) }
        if (times.size == cells.size) return ISO_CLOCK.takeIf { times.first() < times.last() }
        val title = titles.getOrNull(index)?.text.orEmpty().lowercase()
        if (TIMES.none { it in title }) return null
        val numbers = cells.map { it.text.trim().toDoubleOrNull() ?: return null }
        val clock = clockOf(numbers[0]) ?: return null
        val isTime = numbers.all { clockOf(it) == clock } && numbers.zipWithNext().all { (one, next) -> one <= next }
        return clock.takeIf { isTime && numbers.first() < numbers.last() }
    }

    /** Returns the separator that a line such as `sep=;` names, which Excel writes and reads; null for any other line. */
    private fun separatorIn(line: String): Int? {
        // The separator may be a tab.
        val text = line.trim(' ').removeSurrounding("\"")
        return text.takeIf { it.length == SEPARATOR_PREFIX.length + 1 && it.startsWith(SEPARATOR_PREFIX, ignoreCase = true) }?.last()?.code
    }

    private fun linesOf(bytes: ByteArray, from: Int, until: Int, isEnd: Boolean): List<String> {
        val end = minOf(until, from + BYTES)
        val text = CharArray(end - from) { (bytes[from + it].toInt() and 0xff).toChar() }.concatToString()
        val lines = text.split(LF.toChar(), CR.toChar()).let { if (isEnd && end == until) it else it.dropLast(1) }
        return lines.filter { it.isNotBlank() }.take(MAX_LINES)
    }

    private fun split(line: String, separator: Int): List<Cell> {
        val cells = ArrayList<Cell>()
        var at = 0
        while (true) {
            val isQuoted = at < line.length && line[at].code == QUOTE
            var end = at
            if (isQuoted) {
                end = at + 1
                while (end < line.length && (line[end].code != QUOTE || line.getOrNull(end + 1)?.code == QUOTE)) {
                    end += if (line[end].code == QUOTE) 2 else 1
                }
            }
            while (end < line.length && line[end].code != separator) end++
            val text = line.substring(at, end)
            cells += Cell(if (isQuoted) text.trimEnd().removeSurrounding("\"").replace("\"\"", "\"") else text)
            if (end >= line.length) return cells
            at = end + 1
        }
    }

    private const val MARKS = ", '\u00A0"
    private const val SEPARATOR_PREFIX = "sep="
    private const val MAX_CELLS = 1 shl 16
    private val WORDS = setOf("true", "false", "nan", "inf", "-inf", "infinity", "-infinity", "null")
    private val TIMES = listOf("time", "date", "clock", "epoch", "unix")
}
