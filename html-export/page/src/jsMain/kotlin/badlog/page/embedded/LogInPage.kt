package badlog.page.embedded

import badlog.protocol.PageAdditions
import badlog.protocol.fromJson
import org.w3c.fetch.Response
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Promises the files of the log in [page], a page made by badlog; null if it contains no log. The first file has the page's [additions].
 * The promise is rejected if the log was changed since it was exported. Only a piece of the log is in memory at a time.
 */
internal fun logIn(page: File): Promise<List<File>?> = PageScan(page).run()

/** The additions of the page from which the file comes; null for a file that does not come from a page. */
internal var File.additions: PageAdditions?
    get() = asDynamic().additions as PageAdditions?
    set(value) {
        asDynamic().additions = value
    }

private class PageScan(private val page: File) {
    private val gzip = BlobParts()
    private val sums = LineSums()

    /** The text read so far but not scanned yet. */
    private var rest = ""
    private var isInLog = false
    private var hasLog = false

    /** The bytes scanned so far, and those before the log. */
    private var scanned = 0.0
    private var head = 0.0

    /** Promises the files of the log; null if the page has none. Rejected if the log in it is damaged. */
    fun run(): Promise<List<File>?> = readFrom(0.0).then {
        val begin = rest.indexOf(ABOUT)
        when {
            !hasLog -> null

            begin < 0 || isInLog -> error(DAMAGED)

            else -> {
                // Read again as UTF-8, the encoding of the page.
                val end = page.asDynamic().slice(page.size.toDouble() - rest.length + begin + ABOUT.length)
                end.text().unsafeCast<Promise<String>>().then { filesOf(JSON.parse<dynamic>(it.substringBefore('<'))) }
                    .unsafeCast<Promise<List<File>>>().then { files -> additions().then { files.apply { first().additions = it } } }
            }
        }
    }.unsafeCast<Promise<List<File>?>>()

    private fun additions(): Promise<PageAdditions> = page.asDynamic().slice(0, head).text().unsafeCast<Promise<String>>()
        .then { textOf(it.substringAfter(PACKED, "").substringBefore('<')) }.unsafeCast<Promise<String>>()
        .then { if (it.isEmpty()) PageAdditions() else checkNotNull(PageAdditions.fromJson(it)) }
        .catch { PageAdditions(notesProblem = "The notes in ${page.name} cannot be read; open that page itself.") }

    private fun textOf(packed: String): Promise<String> {
        if (packed.isEmpty()) return Promise.resolve("")
        val gzip = BlobParts().apply { addBytes(Base64.decode(packed)) }.toBlob()
        return unpacked(gzip).then { it.asDynamic().text() }.unsafeCast<Promise<String>>()
    }

    private fun filesOf(about: dynamic): Promise<List<File>> {
        check(sums.fit(about.crc32.unsafeCast<Array<Int>>())) { DAMAGED }
        val name = about.name as String
        val gzip = gzip.toBlob()
        if (about.original == "gzip") return Promise.resolve(listOf(File(arrayOf<dynamic>(gzip), name)))
        return unpacked(gzip).then { whole ->
            val second = about.second as String?
            val end = if (second == null) whole.size.toDouble() else (about.firstBytes as Number).toDouble()
            listOfNotNull(
                File(arrayOf<dynamic>(whole.asDynamic().slice(0, end)), name),
                second?.let { File(arrayOf<dynamic>(whole.asDynamic().slice(end)), it) },
            )
        }
    }

    private fun readFrom(from: Double): Promise<Unit> = bytesOf(page, from, from + PIECE).then { bytes ->
        rest += LATIN.decode(bytes).unsafeCast<String>()
        scanned = from + bytes.size
        scan()
        if (bytes.size < PIECE) Unit else readFrom(from + PIECE)
    }.unsafeCast<Promise<Unit>>()

    private fun scan() {
        if (!isInLog && !hasLog) {
            val begin = rest.indexOf(LOG)
            // A name may contain “>”, but no quotes.
            val end = rest.indexOf("\">", maxOf(begin, 0))
            if (begin < 0 || end < 0) return forget()
            head = scanned - rest.length + begin
            rest = rest.substring(end + 2)
            isInLog = true
            hasLog = true
        }
        while (isInLog) {
            val end = rest.indexOfFirst { it == '<' || it == '\n' }
            val length = if (end < 0) rest.length / GROUP * GROUP else end
            val bytes = Base64.decode(rest.substring(0, length))
            gzip.addBytes(bytes)
            val isLineEnd = end >= 0
            sums.add(bytes, isLineEnd)
            rest = rest.substring(length)
            if (!isLineEnd) return
            isInLog = rest[0] == '\n'
            if (isInLog) rest = rest.substring(1)
        }
        forget()
    }

    /** Keeps only the end of the text read so far, because a tag may have been cut in two. */
    private fun forget() {
        rest = rest.takeLast(KEPT_LENGTH)
    }

    private companion object {
        const val LOG = "id=\"recording\""
        const val PACKED = "id=\"packed-additions\">"
        const val ABOUT = "id=\"about\">"
        const val DAMAGED = "the log in it was damaged in copying"

        /** The number of characters to keep of the text read so far; the facts about any log are shorter. */
        const val KEPT_LENGTH = 1 shl 20

        /** The number of base64 characters for three bytes. */
        const val GROUP = 4

        /** Decodes each byte as one character. */
        val LATIN: dynamic = js("new TextDecoder('latin1')")
    }
}

/** Returns what [gzip] inflates to. */
internal fun unpacked(gzip: Blob): Promise<Blob> {
    val stream = gzip.asDynamic().stream().pipeThrough(js("new DecompressionStream('gzip')"))
    return Response(stream).blob()
}
