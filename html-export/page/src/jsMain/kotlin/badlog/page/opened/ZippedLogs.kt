package badlog.page.opened

import badlog.page.dom.place
import badlog.page.embedded.bytesOf
import badlog.page.embedded.unpacked
import org.w3c.files.Blob
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Promises the files in the ZIP [zip] that are named like logs, inflated. Rejected if it is not a ZIP, is damaged, or would grow more than
 * any ZIP of logs.
 */
internal fun logsInZip(zip: File): Promise<List<File>> {
    val size = zip.size.toDouble()
    return bytesOf(zip, maxOf(0.0, size - END_BYTES - MAX_COMMENT), size).then { end ->
        val at = (end.size - END_BYTES downTo 0).first { end.number(it) == END }
        val from = end.number(at + 16)
        bytesOf(zip, from, from + end.number(at + 12))
    }.unsafeCast<Promise<ByteArray>>().then { directory ->
        var at = 0
        val logs = ArrayList<ZippedLog>()
        while (at + ENTRY_BYTES <= directory.size && directory.number(at) == ENTRY) {
            val name = directory.decodeToString(at + ENTRY_BYTES, at + ENTRY_BYTES + directory.short(at + 28)).replace('\\', '/')
            if (OpenedLog.isNamedLikeLog(name)) logs += ZippedLog(name, directory.copyOfRange(at, at + ENTRY_BYTES))
            at += ENTRY_BYTES + directory.short(at + 28) + directory.short(at + 30) + directory.short(at + 32)
        }
        check(logs.sumOf { it.size } <= maxOf(RATIO * size, SMALL))
        Promise.all(logs.map { it.from(zip) }.toTypedArray())
    }.unsafeCast<Promise<Array<File>>>().then { it.toList() }
}

/** A log in a ZIP, with its [entry] in the directory. */
private class ZippedLog(val name: String, val entry: ByteArray) {
    val size = entry.number(24)

    fun from(zip: File): Promise<File> {
        val at = entry.number(42)
        return bytesOf(zip, at, at + HEADER_BYTES).then { header ->
            val from = at + HEADER_BYTES + header.short(26) + header.short(28)
            val part = zip.asDynamic().slice(from, from + entry.number(20))
            // With these bytes around it, the browser compares its checksum, too.
            val packed = arrayOf<dynamic>(GZIP_HEAD, part, entry.copyOfRange(16, 20), entry.copyOfRange(24, 28))
            if (entry.short(10) == 0) part else unpacked(Blob(packed))
        }.unsafeCast<Promise<Blob>>().then { content ->
            check(content.size.toDouble() == size)
            File(arrayOf<dynamic>(content), name.substringAfterLast('/')).also { it.place = name }
        }
    }
}

private fun ByteArray.short(at: Int): Int = (this[at].toInt() and 0xff) or (this[at + 1].toInt() and 0xff shl 8)

private fun ByteArray.number(at: Int): Double = short(at) + short(at + 2) * 65536.0

private const val END = 0x06054b50.toDouble()
private const val END_BYTES = 22
private const val MAX_COMMENT = 65535
private const val ENTRY = 0x02014b50.toDouble()
private const val ENTRY_BYTES = 46
private const val HEADER_BYTES = 30

/** The beginning of a gzip stream without a name. */
private val GZIP_HEAD = byteArrayOf(0x1f, 0x8b.toByte(), 8, 0, 0, 0, 0, 0, 0, 0)

/** As in badlog's window: only zeros become so much smaller. */
private const val RATIO = 200

/** The bytes that any ZIP may inflate to. */
private const val SMALL = 67_108_864.0
