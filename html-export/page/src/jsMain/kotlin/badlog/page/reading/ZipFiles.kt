package badlog.page.reading

import badlog.page.dom.place
import badlog.page.embedded.GZIP
import badlog.page.embedded.bytesOf
import org.khronos.webgl.Int8Array
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/** A file in a ZIP, which begins at [at]; the sizes are in bytes. */
private class ZipEntry(val name: String, val method: Int, val sum: ByteArray, val packed: Double, val size: Double, val at: Double)

/**
 * Promises the unpacked files in [zip] whose paths are [wanted]; each has its path as its place. Rejected with a sentence if it is not a ZIP,
 * is damaged, or grows as no log does. See APPNOTE.TXT of PKWARE for the format.
 */
internal fun filesInZip(zip: File, wanted: (String) -> Boolean): Promise<List<File>> {
    val size = zip.size.toDouble()
    return bytesOf(zip, maxOf(0.0, size - TAIL), size).then { tail ->
        val end = (tail.size - END_SIZE downTo 0).find { tail.number(it, 4) == END } ?: throw Error("It is not a ZIP; make it again.")
        val at = tail.number(end + 16, 4)
        bytesOf(zip, at, at + tail.number(end + 12, 4))
    }.then { list -> unpacked(zip, entriesIn(list.unsafeCast<ByteArray>()).filter { wanted(it.name) }) }.unsafeCast<Promise<List<File>>>()
}

private fun entriesIn(list: ByteArray): List<ZipEntry> = buildList {
    var at = 0
    while (at + ENTRY_SIZE <= list.size && list.number(at, 4) == ENTRY) {
        fun number(place: Int, bytes: Int) = list.number(at + place, bytes)
        val nameEnd = at + ENTRY_SIZE + number(28, 2).toInt()
        // Windows PowerShell 5 writes backslashes.
        val name = list.decodeToString(at + ENTRY_SIZE, minOf(nameEnd, list.size)).replace('\\', '/').removePrefix("./")
        val sum = list.copyOfRange(at + 16, at + 20)
        add(ZipEntry(name, number(10, 2).toInt(), sum, number(20, 4), number(24, 4), number(42, 4)))
        at = nameEnd + number(30, 2).toInt() + number(32, 2).toInt()
    }
}

private fun unpacked(zip: File, entries: List<ZipEntry>): Promise<List<File>> {
    if (entries.sumOf { it.size } > MAX_BYTES) throw Error("Its logs are too large for a page; badlog's window opens it.")
    val grown = entries.filter { it.size > RATIO * it.packed }
    if (grown.sumOf { it.size } > MAX_GROWN) throw Error("“${grown[0].name}” in it grows more than $RATIO times, as no log does; leave it out.")
    val files = ArrayList<File>()
    return entries.fold(Promise.resolve(Unit)) { before, entry ->
        before.then { contentOf(zip, entry) }.unsafeCast<Promise<Blob>>().then {
            files += File(arrayOf(it), entry.name.substringAfterLast('/')).apply { place = entry.name }
        }
    }.then { files }
}

private fun contentOf(zip: File, entry: ZipEntry): Promise<Blob> = bytesOf(zip, entry.at, entry.at + HEAD_SIZE).then { head ->
    val from = entry.at + HEAD_SIZE + head.number(26, 2) + head.number(28, 2)
    val part = zip.asDynamic().slice(from, from + entry.packed).unsafeCast<Blob>()
    if (entry.method == STORED) Promise.resolve(part) else inflated(part, entry)
}.unsafeCast<Promise<Blob>>()

/** Inflates [part]; framed as gzip, so that the browser compares the checksum and the size with those of [entry]. */
private fun inflated(part: Blob, entry: ZipEntry): Promise<Blob> {
    val size = ByteArray(4) { (entry.size.toLong() shr 8 * it).toByte() }
    val stream = Blob(arrayOf(GZIP_HEAD, part, entry.sum, size)).asDynamic().stream()
    val reader = stream.pipeThrough(js("new DecompressionStream('gzip')")).getReader()
    val pieces = ArrayList<Int8Array>()
    var left = entry.size
    fun next(): Promise<Blob> = reader.read().then { read: dynamic ->
        if (read.done == true) {
            Blob(pieces.toTypedArray())
        } else {
            pieces += read.value.unsafeCast<Int8Array>()
            left -= read.value.length as Int
            // A ZIP may name a smaller size than it has.
            if (left < 0) throw Error()
            next()
        }
    }.unsafeCast<Promise<Blob>>()
    return next().catch { throw Error("“${entry.name}” in it is damaged or encrypted; make the ZIP again.") }
}

/** Returns the little-endian number of [bytes] bytes at [at]. */
private fun ByteArray.number(at: Int, bytes: Int): Double =
    (bytes - 1 downTo 0).fold(0.0) { number, i -> number * 256 + ((getOrNull(at + i) ?: 0).toInt() and 0xff) }

private const val END = 101_010_256.0
private const val END_SIZE = 22
private const val ENTRY = 33_639_248.0
private const val ENTRY_SIZE = 46
private const val HEAD_SIZE = 30
private const val STORED = 0

/** The last record of a ZIP, and the longest comment after it, in bytes. */
private const val TAIL = END_SIZE + 65_535

/** The limit of all logs together, in bytes. */
private const val MAX_BYTES = 2e9

/** See `MatchZip` in the module `catalog`. */
private const val RATIO = 200
private const val MAX_GROWN = 64e6
private val GZIP_HEAD = GZIP + byteArrayOf(8, 0, 0, 0, 0, 0, 0, 3)
