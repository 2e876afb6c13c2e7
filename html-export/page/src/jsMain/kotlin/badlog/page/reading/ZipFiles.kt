package badlog.page.reading

import badlog.page.dom.json
import badlog.page.dom.place
import badlog.page.embedded.GZIP
import badlog.page.embedded.PIECE
import badlog.page.embedded.bytesOf
import badlog.protocol.Crc32
import org.khronos.webgl.Int8Array
import org.w3c.files.Blob
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * The content of a ZIP.
 *
 * @property names the paths of all files in it.
 * @property files the unpacked ones; each has its path as its place.
 */
internal class ZipContent(val names: List<String>, val files: List<File>)

/** A file in a ZIP, which begins at [at]; the sizes are in bytes, and [sum] is its CRC-32. */
private class ZipEntry(val name: String, val method: Int, val sum: ByteArray, val packed: Double, val size: Double, val at: Double)

/**
 * Promises the files in [zip] with [wanted] paths. Rejected with a sentence if it is not a ZIP, is damaged, or grows as no log does.
 * See APPNOTE.TXT of PKWARE for the format.
 */
internal fun filesInZip(zip: File, wanted: (String) -> Boolean): Promise<ZipContent> {
    val size = zip.size.toDouble()
    return bytesOf(zip, maxOf(0.0, size - TAIL), size).then { tail ->
        val end = (tail.size - END_SIZE downTo 0).find { tail.number(it, 4) == END && it + END_SIZE + tail.number(it + 20, 2) == tail.size.toDouble() }
        if (end == null) throw Error(UNREADABLE)
        val listSize = tail.number(end + 12, 4)
        // Something may stand before the ZIP, which its numbers do not count.
        val listAt = size - tail.size + end - listSize
        bytesOf(zip, listAt, listAt + listSize).then { list ->
            val all = entriesIn(list, listAt - tail.number(end + 16, 4))
            if (all.size.toDouble() != tail.number(end + 10, 2)) throw Error(UNREADABLE)
            val named = all.filter { !it.name.endsWith('/') }
            unpacked(zip, named.filter { wanted(it.name) }).then { ZipContent(named.map { it.name }, it) }
        }
    }.unsafeCast<Promise<ZipContent>>()
}

private fun entriesIn(list: ByteArray, before: Double): List<ZipEntry> = buildList {
    var at = 0
    while (at + ENTRY_SIZE <= list.size && list.number(at, 4) == ENTRY) {
        fun number(place: Int, bytes: Int) = list.number(at + place, bytes)
        val nameEnd = at + ENTRY_SIZE + number(28, 2).toInt()
        // Windows PowerShell 5 writes backslashes.
        val name = list.decodeToString(at + ENTRY_SIZE, minOf(nameEnd, list.size)).replace('\\', '/').removePrefix("./")
        val isEncrypted = number(8, 2).toInt() and 1 == 1
        val method = if (isEncrypted) ENCRYPTED else number(10, 2).toInt()
        add(ZipEntry(name, method, list.copyOfRange(at + 16, at + 20), number(20, 4), number(24, 4), before + number(42, 4)))
        at = nameEnd + number(30, 2).toInt() + number(32, 2).toInt()
    }
}

private fun unpacked(zip: File, entries: List<ZipEntry>): Promise<List<File>> {
    if (entries.sumOf { it.size } > MAX_BYTES) throw Error("Its logs are too large for a page together; badlog's window opens it.")
    val grown = entries.filter { it.size > RATIO * it.packed }
    if (grown.sumOf { it.size } > MAX_GROWN) {
        throw Error("“${grown[0].name}” in it grows more than $RATIO times, as no log does; leave it out.")
    }
    if (entries.distinctBy { it.name }.size < entries.size) throw Error("It has two files of one name; make it again.")
    val files = ArrayList<File>()
    val time = json("lastModified" to zip.asDynamic().lastModified).unsafeCast<FilePropertyBag>()
    return entries.fold(Promise.resolve(Unit)) { before, entry ->
        before.then { contentOf(zip, entry) }.unsafeCast<Promise<Blob>>().then {
            files += File(arrayOf(it), entry.name.substringAfterLast('/'), time).apply { place = entry.name }
        }
    }.then { files }
}

private fun contentOf(zip: File, entry: ZipEntry): Promise<Blob> = bytesOf(zip, entry.at, entry.at + HEAD_SIZE).then { head ->
    val from = entry.at + HEAD_SIZE + head.number(26, 2) + head.number(28, 2)
    val part = zip.asDynamic().slice(from, from + entry.packed).unsafeCast<Blob>()
    when (entry.method) {
        STORED -> stored(part, entry)
        DEFLATED -> inflated(part, entry)
        else -> throw Error("“${entry.name}” in it is encrypted, or packed as browsers cannot unpack it; make a usual ZIP.")
    }
}.unsafeCast<Promise<Blob>>()

private fun stored(part: Blob, entry: ZipEntry): Promise<Blob> {
    val sum = Crc32()
    fun next(from: Double): Promise<Blob> = bytesOf(part, from, from + PIECE).then { bytes ->
        sum.update(bytes)
        when {
            bytes.size == PIECE -> next(from + PIECE)
            ByteArray(4) { (sum.value shr 8 * it).toByte() }.contentEquals(entry.sum) -> part
            else -> throw damaged(entry)
        }
    }.unsafeCast<Promise<Blob>>()
    return next(0.0)
}

/** Inflates [part]; framed as gzip, so that the browser compares checksum and size with the values in [entry]. */
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
    return next().catch { throw damaged(entry) }
}

private fun damaged(entry: ZipEntry) = Error("“${entry.name}” in it is damaged; make the ZIP again.")

/** Returns the little-endian number of [bytes] bytes at [at]. */
private fun ByteArray.number(at: Int, bytes: Int): Double =
    (bytes - 1 downTo 0).fold(0.0) { number, i -> number * 256 + ((getOrNull(at + i) ?: 0).toInt() and 0xff) }

private const val UNREADABLE = "This is not a ZIP that can be read; make it again."
private const val END = 101_010_256.0
private const val END_SIZE = 22
private const val ENTRY = 33_639_248.0
private const val ENTRY_SIZE = 46
private const val HEAD_SIZE = 30
private const val STORED = 0
private const val DEFLATED = 8
private const val ENCRYPTED = -1

/** The last record of a ZIP, and the longest comment after it, in bytes. */
private const val TAIL = END_SIZE + 65_535

/** The limit of all logs together, in bytes: a page has each of them, and the joined log, in memory. */
private const val MAX_BYTES = 300e6

/** See `MatchZip` in the module `catalog`. */
private const val RATIO = 200
private const val MAX_GROWN = 64e6
private val GZIP_HEAD = GZIP + byteArrayOf(8, 0, 0, 0, 0, 0, 0, 3)
