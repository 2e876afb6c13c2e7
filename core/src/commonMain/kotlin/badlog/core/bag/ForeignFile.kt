package badlog.core.bag

/** The number of bytes that [foreignFile] needs; pass fewer only if the file is shorter. */
internal const val FOREIGN_BYTES: Int = 512

/**
 * Returns a sentence about a file that is certainly not a readable log: its kind, and what to do. Returns null for any other file.
 *
 * @param bytes the first bytes of the file.
 */
internal fun foreignFile(bytes: ByteArray): String? {
    val text = CharArray(bytes.size) { (bytes[it].toInt() and 0xff).toChar() }.concatToString()
    return SIGNATURES.firstOrNull { (at, mark) -> text.startsWith(mark, at) }?.sentence ?: when {
        isRlog(text) -> RLOG
        isRoadRunner(text) -> ROAD_RUNNER
        text.startsWith(ZIP) -> if (WORKBOOKS.any { it in text }) WORKBOOK else ARCHIVE
        else -> markup(text)
    }
}

private data class Signature(val at: Int, val mark: String, val sentence: String)

private const val ZIP = "PK\u0003\u0004"
private const val ARCHIVE = "This is an archive of files; unpack it, and open the logs in it."
private const val WORKBOOK = "This is a spreadsheet's own file; save it as CSV UTF-8, and open that."
private const val PICTURE = "This is a picture, not a log."
private const val VIDEO = "This is a video, not a log; open a log, and then the video beside it."
private const val COMPRESSED = "This file is compressed in a way that cannot be read here; inflate it first."
private const val RLOG = "This is an RLOG, which AdvantageKit wrote in 2022; open it in AdvantageScope, and export it as a WPILOG."
private const val ROAD_RUNNER = "This is a log of Road Runner; open it in AdvantageScope, and export it as a WPILOG."
private const val WEB_PAGE =
    "This is a web page in place of a log, perhaps a server's error message; download the log again, or open the page in a browser."

private val SIGNATURES = listOf(
    Signature(0, "#ROSBAG V", "This is a ROS bag, which has only its name in common with a bag of badlog; export its topics as CSV."),
    Signature(0, "SQLite format 3\u0000", "This is an SQLite database, such as a bag of ROS 2; export its tables as CSV."),
    Signature(0, "\u0089MCAP0\r\n", "This is an MCAP log; open it in the program that wrote it, and export it as a WPILOG or CSV."),
    Signature(0, "PAR1", "This is a Parquet table; open the log that it was made of, or ask it with `badlog sql`."),
    Signature(0, "%PDF-", "This is a PDF document, not a log."),
    Signature(0, "version https://git-lfs", "This is a pointer of Git LFS in place of a log; run `git lfs pull` in its folder."),
    Signature(0, "PK\u0005\u0006", "This is an empty ZIP archive."),
    Signature(257, "ustar", ARCHIVE),
    Signature(0, "Rar!\u001a\u0007", ARCHIVE),
    Signature(0, "7z\u00bc\u00af\u0027\u001c", ARCHIVE),
    Signature(0, "\u00fd7zXZ\u0000", COMPRESSED),
    Signature(0, "\u0028\u00b5\u002f\u00fd", COMPRESSED),
    Signature(4, "1AY&SY", COMPRESSED),
    Signature(0, "\u00d0\u00cf\u0011\u00e0\u00a1\u00b1\u001a\u00e1", WORKBOOK),
    Signature(0, "\u0089PNG\r\n", PICTURE),
    Signature(0, "\u00ff\u00d8\u00ff", PICTURE),
    Signature(0, "GIF87a", PICTURE),
    Signature(0, "GIF89a", PICTURE),
    // The zeros before it are skipped, as after a loss of power.
    Signature(1, "ftyp", VIDEO),
    Signature(0, "\u001a\u0045\u00df\u00a3", VIDEO),
)

/** Names in the first bytes of a ZIP that a spreadsheet program wrote. */
private val WORKBOOKS = listOf("[Content_Types].xml", "opendocument.spreadsheet")

/**
 * Returns whether [text] begins like an RLOG. An RLOG begins with a version, a time as a double, and the first field's number, name length
 * and name.
 */
private fun isRlog(text: String): Boolean {
    if (text.length < RLOG_NAME + 2 || text[0].code !in 1..2 || text[1].code != 0 || text[RLOG_FIELD].code != 1) return false
    val length = text[RLOG_NAME - 2].code shl 8 or text[RLOG_NAME - 1].code
    return length in 1..MAX_NAME && text.drop(RLOG_NAME).take(length).all { it in ' '..'~' }
}

/** Two letters, and a version of two bytes. */
private fun isRoadRunner(text: String) = text.length >= 4 && text.startsWith("RR\u0000") && text[3].code <= 2

private fun markup(text: String): String? {
    val begin = text.removePrefix("\u00ef\u00bb\u00bf").trimStart().lowercase()
    return when {
        PAGES.any(begin::startsWith) -> WEB_PAGE
        begin.startsWith("<?xml") -> if ("<html" in begin) WEB_PAGE else "This is an XML file, not a log."
        else -> null
    }
}

private val PAGES = listOf("<!doctype html", "<html", "<head", "<body")

/** The start of an RLOG's first field, and the start of that field's name. */
private const val RLOG_FIELD = 10
private const val RLOG_NAME = 15
private const val MAX_NAME = 1000
