package badlog.bag

import badlog.recording.Loss
import badlog.recording.ProblemKind
import badlog.recording.ProblemList
import badlog.text.BRACE
import badlog.text.TAB
import badlog.text.TextDecoder

/** Reads what stands before the rows: the line of JSON, if there is one, and the line of column titles. */
internal class HeaderReader(private val pending: PendingBytes, private val decoder: TextDecoder, private val problems: ProblemList) {
    private enum class Stage { SIGNATURE, FIRST_LINE, TITLES, DONE }

    private var stage = Stage.SIGNATURE

    /** The line of JSON as it stands there, or null without one. */
    var line: String? = null
        private set

    /** What it says; null without it, and where it cannot be read. */
    var header: BagHeader? = null
        private set

    /** The columns; null until they are known, and where the titles line is missing or cut. */
    var columns: HeaderColumns? = null
        private set

    /** Whether nothing of the header is still to come. */
    val isDone: Boolean get() = stage == Stage.DONE

    /** Whether the bytes turned out not to be a log. */
    var isNoLog = false
        private set

    /** Reads one line of it; returns where the next begins, or [RowScanner.INCOMPLETE]. */
    fun read(isEnd: Boolean): Int = when (stage) {
        Stage.SIGNATURE -> readSignature(isEnd)
        Stage.FIRST_LINE -> readLine(isEnd, ::takeFirstLine)
        Stage.TITLES -> readLine(isEnd, ::takeTitles)
        Stage.DONE -> pending.end
    }

    private fun readSignature(isEnd: Boolean): Int {
        if (pending.size < FileSignature.BYTES && !isEnd) return RowScanner.INCOMPLETE
        val start = pending.start
        val seen = pending.bytes.copyOfRange(start, minOf(pending.end, start + FileSignature.BYTES))
        when (FileSignature.of(seen)) {
            FileSignature.GZIP -> return refuse("The file is compressed with gzip and has to be inflated first.")
            FileSignature.WPILOG -> return refuse("This is a WPILOG file, not a bag.")
            FileSignature.OTHER -> stage = Stage.FIRST_LINE
        }
        if (seen.size >= 2 && (startsWith(seen, 0xFF, 0xFE) || startsWith(seen, 0xFE, 0xFF))) {
            return refuse("The file is UTF-16, as Excel's “Unicode text” is; save it again as CSV UTF-8.")
        }
        val hasMark = seen.size >= BYTE_ORDER_MARK.size && BYTE_ORDER_MARK.indices.all { seen[it] == BYTE_ORDER_MARK[it] }
        if (!hasMark) return start
        problems.add(ProblemKind.BYTE_ORDER_MARK, "The file begins with a byte order mark, which was skipped.", 1)
        return start + BYTE_ORDER_MARK.size
    }

    private fun startsWith(bytes: ByteArray, first: Int, second: Int) = bytes[0] == first.toByte() && bytes[1] == second.toByte()

    private fun readLine(isEnd: Boolean, take: (lineEnd: Int, next: Int) -> Int): Int {
        val bytes = pending.bytes
        val lineEnd = lineEndIn(bytes, pending.start, pending.end)
        // Once the first line has shown a bag, a stray control character is no reason to lose everything.
        val mayBeBinary = header == null && (lineEnd == pending.start || bytes[pending.start].toInt() != BRACE)
        if (mayBeBinary && isBinary(pending.start, lineEnd)) return refuse(BINARY)
        if (lineEnd - pending.start > MAX_LINE_BYTES) return refuse(BINARY)
        if (lineEnd == pending.end && !isEnd) return RowScanner.INCOMPLETE
        val next = afterLineEnd(bytes, lineEnd, pending.end, isEnd)
        if (next == RowScanner.INCOMPLETE) return next
        if (lineEnd > pending.start) return take(lineEnd, next)
        if (!pending.isAfterHole) problems.add(ProblemKind.BLANK_LINE, "A blank line was skipped.", pending.line)
        pending.line++
        return next
    }

    private fun takeFirstLine(lineEnd: Int, next: Int): Int {
        stage = Stage.TITLES
        if (pending.bytes[pending.start].toInt() != BRACE) return pending.start
        val text = decode(lineEnd)
        line = text
        header = readHeader(text)
        if (header == null) {
            problems.add(
                ProblemKind.HEADER_UNREADABLE,
                "Line ${pending.line} is cut or is not JSON, so units, attributes and values are lost; " +
                    "the rest was read as CSV.",
                pending.line,
                loss = Loss(bytes = (lineEnd - pending.start).toLong()),
            )
        }
        if (next > lineEnd) pending.line++
        return next
    }

    private fun takeTitles(lineEnd: Int, next: Int): Int {
        val isCut = next == lineEnd
        // What a hole has left of the line of JSON holds no titles.
        val isRestOfJson = line != null && header == null && pending.isAfterHole
        if (!isRestOfJson) {
            stage = Stage.DONE
            val titles = titles(lineEnd)
            if (header == null && titles.size == 1) otherSeparator(titles[0])?.let { return refuse(it) }
            val names = header?.topics.orEmpty().map { it.name }
            // The line of JSON knows the topics better than a line of titles that is cut, or that a hole has taken.
            val isRow = pending.holeLine > 0 && names.isNotEmpty() && titles.none { it in names }
            val known = if (isRow || (isCut && names.isNotEmpty())) names else titles
            columns = HeaderColumns.match(header, known, pending.line, problems)
            if (isRow) return pending.start
        }
        if (!isCut) pending.line++
        return next
    }

    private fun otherSeparator(title: String): String? = when {
        ';' in title -> "The columns are separated by semicolons; save the file again as CSV with commas."
        '\t' in title -> "The columns are separated by tabs; save the file again as CSV with commas."
        else -> null
    }

    private fun titles(lineEnd: Int): List<String> {
        // The original does not quote names, so a name with a comma is told only by the line of JSON.
        val names = header?.topics?.map { it.name }
        if (names != null && names.size > 1 && decode(lineEnd) == names.joinToString(",")) return names
        val splitter = RowSplitter()
        val count = splitter.split(pending.bytes, pending.start, lineEnd, RowSplitter.Quotes.STRICT)
        return List(count) { index ->
            val title = decoder.decode(pending.bytes, splitter.starts[index], splitter.ends[index])
            reportEncoding()
            if (splitter.quoted[index]) title.replace("\"\"", "\"") else title.trim()
        }
    }

    private fun decode(lineEnd: Int): String = decoder.decode(pending.bytes, pending.start, lineEnd).also { reportEncoding() }

    private fun reportEncoding() {
        if (!decoder.wasNotUtf8) return
        problems.add(ProblemKind.NOT_UTF8, "The header is not UTF-8; it was read as Windows-1252.", pending.line)
    }

    private fun isBinary(from: Int, until: Int): Boolean {
        for (i in from until until) if (pending.bytes[i] in CONTROLS && pending.bytes[i].toInt() != TAB) return true
        return false
    }

    private fun refuse(message: String): Int {
        problems.add(ProblemKind.NOT_A_RECORDING, message, pending.line)
        stage = Stage.DONE
        isNoLog = true
        return pending.end
    }

    companion object {
        const val NO_LOG = "This file is neither a bag, nor a CSV file, nor a WPILOG"

        private const val BINARY = "$NO_LOG: it holds bytes that no text has."

        /** No header line is longer; a file without a newline before is not a bag. */
        private const val MAX_LINE_BYTES = 1 shl 24
        private val BYTE_ORDER_MARK = byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte())
        private val CONTROLS = 1.toByte()..31.toByte()
    }
}

/** What kind of file the first bytes show. */
internal enum class FileSignature {
    /** A gzip stream, which has to be inflated. */
    GZIP,

    /** A WPILOG of WPILib's DataLog. */
    WPILOG,

    /** Anything else: a bag, a CSV file, or nothing that can be read. */
    OTHER,
    ;

    companion object {
        /** How many bytes [of] wants to see; fewer are a shorter file. */
        const val BYTES: Int = 6

        /** The signature of a file that begins with the first [count] of [bytes]. */
        fun of(bytes: ByteArray, count: Int = bytes.size): FileSignature = when {
            count >= 2 && bytes[0] == 0x1f.toByte() && bytes[1] == 0x8b.toByte() -> GZIP
            count >= 6 && bytes.decodeToString(0, 6) == "WPILOG" -> WPILOG
            else -> OTHER
        }
    }
}
