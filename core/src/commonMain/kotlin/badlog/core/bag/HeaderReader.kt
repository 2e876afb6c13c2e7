package badlog.core.bag

import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.core.text.BRACE
import badlog.core.text.COMMA
import badlog.core.text.CR
import badlog.core.text.LF
import badlog.core.text.NUL
import badlog.core.text.TextDecoder

/** Reads the lines before the rows: the line of JSON, if there is one, and the line of column titles. */
internal class HeaderReader(private val pending: PendingBytes, private val decoder: TextDecoder, private val problems: ProblemList) {
    private enum class Stage { SIGNATURE, FIRST_LINE, DIALECT, TITLES, DONE }

    private var stage = Stage.SIGNATURE
    private val firstLines = FirstLines(pending, CellReader())
    private var sawOtherText = false
    private var mayBeUtf16 = false

    /** The line of JSON exactly as in the file, or null if there is none. */
    var line: String? = null
        private set

    /** The content of the line of JSON; null if there is none, or it cannot be read. */
    var header: BagHeader? = null
        private set

    /** The translation of the bytes that follow; null for a bag and for a CSV file of the usual form. */
    var translation: CsvTranslation? = null
        private set
    private var clocks = emptyMap<Int, Double>()

    /** The columns; null until they are known, and if the line of titles is missing or cut. */
    var columns: HeaderColumns? = null
        private set

    /** Whether the whole header has been read. */
    val isDone: Boolean get() = stage == Stage.DONE

    /** Whether the bytes turned out not to be a log. */
    var isNotLog = false
        private set

    /** Reads one line of the header. Returns where the next begins, or [RowScanner.INCOMPLETE]. */
    fun read(isEnd: Boolean): Int = when (stage) {
        Stage.SIGNATURE -> readSignature(isEnd)
        Stage.FIRST_LINE -> readLine(isEnd) { lineEnd, next, _ -> takeFirstLine(lineEnd, next) }
        Stage.DIALECT -> readDialect(isEnd)
        Stage.TITLES -> readLine(isEnd, ::takeTitles)
        Stage.DONE -> pending.end
    }

    private fun readSignature(isEnd: Boolean): Int {
        val isBag = pending.size >= FileSignature.BYTES && pending.bytes[pending.start].toInt() == BRACE
        if (pending.size < FOREIGN_BYTES && !isBag && !isEnd) return RowScanner.INCOMPLETE
        val start = pending.start
        val seen = pending.bytes.copyOfRange(start, minOf(pending.end, start + FOREIGN_BYTES))
        when (FileSignature.of(seen)) {
            FileSignature.GZIP -> return refuse("The file is compressed with gzip and has to be inflated first.")
            FileSignature.WPILOG -> return refuse("This is a WPILOG file, not a bag.")
            FileSignature.OTHER -> stage = Stage.FIRST_LINE
        }
        foreignFile(seen)?.let { return refuse(it) }
        mayBeUtf16 = seen.size >= 2 && (startsWith(seen, 0xFF, 0xFE) || startsWith(seen, 0xFE, 0xFF))
        if (mayBeUtf16 && seen.any { it.toInt() == NUL }) return refuse(UTF_16)
        val hasMark = seen.size >= BYTE_ORDER_MARK.size && BYTE_ORDER_MARK.indices.all { seen[it] == BYTE_ORDER_MARK[it] }
        if (!hasMark) return start
        problems.add(ProblemKind.BYTE_ORDER_MARK, "The file begins with a byte order mark, which was skipped.", 1)
        return start + BYTE_ORDER_MARK.size
    }

    private fun startsWith(bytes: ByteArray, first: Int, second: Int) = bytes[0] == first.toByte() && bytes[1] == second.toByte()

    private fun readLine(isEnd: Boolean, take: (lineEnd: Int, next: Int, isEnd: Boolean) -> Int): Int {
        val bytes = pending.bytes
        val lineEnd = lineEndIn(bytes, pending.start, pending.end)
        if (lineEnd - pending.start > MAX_LINE_BYTES) return refuse(BINARY)
        if (lineEnd == pending.end && !isEnd) return RowScanner.INCOMPLETE
        val next = afterLineEnd(bytes, lineEnd, pending.end, isEnd)
        if (next == RowScanner.INCOMPLETE) return next
        if (lineEnd > pending.start) return take(lineEnd, next, isEnd)
        return pending.skipBlankLines(lineEnd, next, problems)
    }

    private fun takeFirstLine(lineEnd: Int, next: Int): Int {
        if (pending.bytes[pending.start].toInt() != BRACE) {
            stage = Stage.DIALECT
            return pending.start
        }
        stage = Stage.TITLES
        val text = decode(pending.start, lineEnd)
        reportEncoding()
        line = text
        header = readHeader(text)
        if (header == null) {
            reportUnreadable(
                "Line ${pending.line} is cut or is not JSON, so units, attributes and values are lost; the rest was read as CSV.",
                lineEnd,
            )
        }
        if (next > lineEnd) pending.line++
        return next
    }

    /** Determines how a file without a line of JSON separates cells and writes numbers. */
    private fun readDialect(isEnd: Boolean): Int {
        if (pending.size < DialectSearch.BYTES && !isEnd) return RowScanner.INCOMPLETE
        val dialect = DialectSearch.of(pending.bytes, pending.start, pending.end, isEnd)
        stage = Stage.TITLES
        clocks = dialect.clocks
        dialect.sentence?.let { problems.add(ProblemKind.CSV_DIALECT, it, pending.line) }
        if (dialect.isNamed) {
            val lineEnd = lineEndIn(pending.bytes, pending.start, pending.end)
            pending.advanceTo(afterLineEnd(pending.bytes, lineEnd, pending.end, true))
            pending.line++
        }
        if (!dialect.isUsual) {
            translation = CsvTranslation(dialect).also {
                pending.translate(it)
                if (isEnd) pending.finish(it)
            }
        }
        return pending.start
    }

    private fun takeTitles(lineEnd: Int, next: Int, isEnd: Boolean): Int {
        val isCut = next == lineEnd
        // The rest of a line of JSON after a hole is not the line of titles.
        if (line != null && header == null && pending.isAfterHole) {
            if (!isCut) pending.line++
            return next
        }
        if (line != null && header == null && isRestOfJson(lineEnd)) {
            reportUnreadable("Line ${pending.line} is part of the JSON line before it; it was skipped.", lineEnd)
            if (!isCut) pending.line++
            return next
        }
        val columns = (pending.start until lineEnd).count { pending.bytes[it].toInt() == COMMA } + 1
        if (columns > MAX_COLUMNS) return refuse("Line ${pending.line} has $columns titles; a log has at most $MAX_COLUMNS topics.")
        val names = header?.topics.orEmpty().map { it.name }
        val titles = titles(lineEnd, names)
        val isSure = header != null && titles.sorted() == names.sorted()
        if (!isSure && !firstLines.look(isEnd)) return RowScanner.INCOMPLETE
        stage = Stage.DONE
        return if (header == null) takeWithoutHeader(titles, lineEnd, next) else takeWithHeader(names, titles, isSure, next, isCut)
    }

    /** Returns whether this is a piece of the line of JSON that damage split off with a newline. */
    private fun isRestOfJson(lineEnd: Int): Boolean = (pending.start..lineEnd - JSON_MARKS[0].length).any { at ->
        JSON_MARKS.any { mark -> mark.indices.all { pending.bytes[at + it].toInt() == mark[it].code } }
    }

    private fun takeWithHeader(names: List<String>, titles: List<String>, isSure: Boolean, next: Int, isCut: Boolean): Int {
        reportEncoding()
        val width = if (isSure) 0 else clearWidth(names.size)
        val isNone = names.isNotEmpty() && titles.none { it in names }
        // Line 2 may be lost, to a hole or to damage: then this is a row.
        val isRow = isNone && (pending.holeLine > 0 || (names.size == width && titles.size == width && firstLines.lines[0].numbers > 0))
        // The line of JSON is more reliable than a line of titles that is cut.
        val isOnlyNames = isRow || (isCut && names.isNotEmpty() && width == 0)
        val known = if (isOnlyNames) ColumnTitles(names) else ColumnTitles.of(names, titles, width)
        columns = columnsOf(known, titles)
        val end = if (!isCut && !isRow && titles.size != width && width > 0) restOfTitles(next, width) else next
        if (pending.holeLine == 0 && !isCut && (isRow || (width > 0 && names.size == width && titles.size != width))) {
            problems.add(
                ProblemKind.TITLES_DAMAGED,
                "Line ${pending.line} does not have a title for each of the $width cells of a row; the names of line 1 were used.",
                pending.line,
                loss = Loss(bytes = (end - next).toLong()),
            )
        }
        if (isRow) return pending.start
        if (!isCut) pending.line++
        pending.line += linesIn(next, end)
        return end
    }

    /** Returns the number of cells in a row; 0 if that is not clear. */
    private fun clearWidth(names: Int): Int = firstLines.width.takeIf { it == names || firstLines.rowsOf(it) >= MIN_ROWS } ?: 0

    /** Handles a plain CSV file, or the rest of a bag if its first line cannot be read. */
    private fun takeWithoutHeader(titles: List<String>, lineEnd: Int, next: Int): Int {
        val width = clearWidth(0)
        val isDamaged = width > 1 && titles.size != width
        val mayBeBinary = mayBeUtf16 || FirstLines.hasControls(pending.bytes, pending.start, lineEnd)
        if (firstLines.isBinary || (mayBeBinary && !firstLines.hasRows)) return refuse(if (mayBeUtf16) UTF_16 else BINARY)
        reportEncoding()
        if (titles.size == 1 && width <= 1) otherSeparator(titles[0])?.let { return refuse(it) }
        if (isDamaged && firstLines.hasRows) {
            // Damage, or remarks of the file's author, may come before the titles.
            val begin = firstLines.lines.firstOrNull { it.cells == width }
            if (begin?.isTitles == true) return skipTo(begin)
        }
        val first = firstLines.lines.firstOrNull()
        if (first != null && titles.size == width && (first.texts == 0 || (line != null && first.numbers > 0))) return takeUntitled(width)
        val known = if (isDamaged) ColumnTitles.of(emptyList(), titles, width) else ColumnTitles(titles)
        // A hole destroyed the rest of the line, which may have had more titles.
        if (next == lineEnd && firstLines.hasRows) known.isDoubtful.fill(true)
        for (i in known.titles.indices) if (known.titles[i].any(::isControl)) known.isDoubtful[i] = true
        columns = columnsOf(known.map { title -> title.map { if (isControl(it)) ' ' else it }.joinToString("") }, titles)
        if (next > lineEnd) pending.line++
        val end = if (isDamaged && next > lineEnd) restOfTitles(next, width) else next
        pending.line += linesIn(next, end)
        return if (end == next) takeUnits(width, next) else end
    }

    /** Takes a line of units below the titles, if there is one, and the known times of day. Returns where the next line begins. */
    private fun takeUnits(width: Int, next: Int): Int {
        val line = firstLines.lines.getOrNull(1)?.takeIf { it.from == next && it.cells == width && width > 1 && firstLines.isUnitLine(it) }
        val units = line?.let { textsIn(it.from, it.end, emptyList()) }.orEmpty().map { it.trim('[', ']', '(', ')', ' ') }
        val isAxis = clocks.keys.minOrNull()
        val names = columns?.columnNames.orEmpty()
        columns = columns?.describedBy { index ->
            val unit = if (index in clocks) "s" else units.getOrNull(index).orEmpty()
            BagTopic(names[index], unit.ifEmpty { "ul" }, if (index == isAxis) listOf("xaxis") else emptyList())
        }
        clocks.keys.forEach(::reportClock)
        if (line == null) return next
        problems.add(ProblemKind.CSV_DIALECT, "Line ${pending.line} has units instead of values; they were taken as such.", pending.line)
        pending.line++
        return line.next
    }

    /** Reports that column [index] has times of day, if there is such a column. */
    fun reportClock(index: Int) {
        val name = columns?.columnNames?.getOrNull(index) ?: return
        problems.add(ProblemKind.CSV_DIALECT, "“$name” has times of day; they were read as seconds since the first one.", topic = name)
    }

    private fun isControl(char: Char) = char < ' ' && char != '\t'

    /** The line of titles is missing: this one is a row. */
    private fun takeUntitled(width: Int): Int {
        problems.add(
            ProblemKind.TITLES_DAMAGED,
            "Line ${pending.line} has values in place of titles; the columns are named by number.",
            pending.line,
        )
        columns = HeaderColumns.match(header, List(width) { "" }, pending.line, problems)
        return pending.start
    }

    /** Continues at the line [titles]; all earlier bytes are lost. */
    private fun skipTo(titles: FirstLines.Line): Int {
        val text = decoder.decode(pending.bytes, pending.start, firstLines.lines[0].end)
        if (line == null && "\"name\":" in text) line = text
        reportUnreadable("Line ${pending.line} is not the start of a bag or CSV file; it was skipped.", titles.from)
        pending.line += linesIn(pending.start, titles.from)
        stage = Stage.TITLES
        return titles.from
    }

    /** Returns where the pieces that damage split off the line of titles end: they are not rows. */
    private fun restOfTitles(next: Int, width: Int): Int = firstLines.lines.drop(1)
        .takeWhile { it.cells != width && it.numbers == 0 && it.next > it.end }.lastOrNull()?.next ?: next

    private fun linesIn(from: Int, until: Int): Int {
        val bytes = pending.bytes
        return (from until until).count { bytes[it].toInt() == LF || (bytes[it].toInt() == CR && bytes[it + 1].toInt() != LF) }
    }

    private fun reportUnreadable(message: String, end: Int) {
        problems.add(ProblemKind.HEADER_UNREADABLE, message, pending.line, loss = Loss(bytes = (end - pending.start).toLong()))
    }

    private fun columnsOf(known: ColumnTitles, titles: List<String>): HeaderColumns {
        val matched = HeaderColumns.match(header, known.titles, pending.line, problems)
        for (i in known.titles.indices) {
            if (!known.isDoubtful[i]) continue
            val name = matched.columnNames[i]
            val other = titles.getOrNull(i)?.takeIf { it != name }
            val reason = if (other == null) "the title line is damaged" else "line ${pending.line} has “$other” there"
            problems.add(
                ProblemKind.NAME_IN_DOUBT,
                "Column ${i + 1} is shown as “$name”, which may be wrong: $reason.",
                pending.line,
                name,
            )
        }
        return matched
    }

    private fun otherSeparator(title: String): String? = when {
        isSeparator(';', title) -> "The columns are separated by semicolons; save the file again as CSV with commas."
        isSeparator('\t', title) -> "The columns are separated by tabs; save the file again as CSV with commas."
        else -> null
    }

    private fun isSeparator(char: Char, title: String): Boolean {
        val row = firstLines.lines.getOrNull(1) ?: return char in title
        return char in title && (row.from until row.end).any { pending.bytes[it].toInt() == char.code }
    }

    private fun titles(lineEnd: Int, names: List<String>): List<String> = textsIn(pending.start, lineEnd, names)

    private fun textsIn(from: Int, lineEnd: Int, names: List<String>): List<String> {
        sawOtherText = false
        // The original does not quote names, so only the line of JSON shows that a name has a comma.
        if (names.size > 1 && decode(from, lineEnd) == names.joinToString(",")) return names
        val splitter = RowSplitter()
        val count = splitter.split(pending.bytes, from, lineEnd, RowSplitter.Quotes.STRICT)
        return List(count) { index ->
            val title = decode(splitter.starts[index], splitter.ends[index])
            if (splitter.quoted[index]) title.replace("\"\"", "\"") else title.trim()
        }
    }

    private fun decode(from: Int, until: Int): String = decoder.decode(pending.bytes, from, until).also {
        if (decoder.wasNotUtf8) sawOtherText = true
    }

    private fun reportEncoding() {
        if (sawOtherText) problems.add(ProblemKind.NOT_UTF8, "The header is not UTF-8; it was read as Windows-1252.", pending.line)
    }

    private fun refuse(message: String): Int {
        problems.add(ProblemKind.NOT_A_RECORDING, message, pending.line)
        stage = Stage.DONE
        isNotLog = true
        return pending.end
    }

    companion object {
        const val NOT_A_LOG = "This file is not a log that badlog can read"

        private const val BINARY = "$NOT_A_LOG: it has bytes that never occur in text."
        private const val UTF_16 = "The file is UTF-16, like Excel's “Unicode text”; save it again as CSV UTF-8."

        /** The longest header line; a file without a newline in so many bytes is not a bag. */
        private const val MAX_LINE_BYTES = 1 shl 24
        private val BYTE_ORDER_MARK = byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte())

        /** A limit, because each column takes memory before it has any row. */
        private const val MAX_COLUMNS = 1 shl 16

        /** Characters between a key and its value in JSON, which no title contains. */
        private val JSON_MARKS = listOf("\":\"", "\":[")

        /** From this many rows of one width on, their width counts, not the titles' width. */
        private const val MIN_ROWS = 3
    }
}

/** The kind of a file according to its first bytes. */
internal enum class FileSignature {
    /** A gzip stream, which must be inflated. */
    GZIP,

    /** A WPILOG of WPILib's DataLog. */
    WPILOG,

    /** Anything else: a bag, a CSV file, or something that cannot be read. */
    OTHER,
    ;

    companion object {
        /** The number of bytes that [of] needs; pass fewer only if the file is shorter. */
        const val BYTES: Int = 6

        /** Returns the signature of a file that begins with the first [count] of [bytes]. */
        fun of(bytes: ByteArray, count: Int = bytes.size): FileSignature = when {
            count >= 2 && bytes[0] == 0x1f.toByte() && bytes[1] == 0x8b.toByte() -> GZIP
            count >= 6 && bytes.decodeToString(0, 6) == "WPILOG" -> WPILOG
            else -> OTHER
        }
    }
}
