package badlog.page.opened

import badlog.page.dom.place
import badlog.page.embedded.bytesOf
import org.w3c.fetch.Response
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
            if (OpenedLog.isNamedLikeLog(name)) {
                logs += ZippedLog(name, directory.short(at + 10), directory.number(at + 20), directory.number(at + 24), directory.number(at + 42))
            }
            at += ENTRY_BYTES + directory.short(at + 28) + directory.short(at + 30) + directory.short(at + 32)
        }
        check(logs.sumOf { it.size } <= maxOf(RATIO * size, SMALL))
        Promise.all(logs.map { it.from(zip) }.toTypedArray())
    }.unsafeCast<Promise<Array<File>>>().then { it.toList() }
}

/** A log in a ZIP, [packed] bytes that inflate to [size]; its header is [at] this byte. */
private class ZippedLog(val name: String, val method: Int, val packed: Double, val size: Double, val at: Double) {
    fun from(zip: File): Promise<File> = bytesOf(zip, at, at + HEADER_BYTES).then { header ->
        val from = at + HEADER_BYTES + header.short(26) + header.short(28)
        val part = zip.asDynamic().slice(from, from + packed)
        if (method == 0) part else Response(part.stream().pipeThrough(js("new DecompressionStream('deflate-raw')"))).blob()
    }.unsafeCast<Promise<Blob>>().then { content ->
        check(content.size.toDouble() == size)
        File(arrayOf<dynamic>(content), name.substringAfterLast('/')).also { it.place = name }
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

/** As in badlog's window: only zeros become so much smaller. */
private const val RATIO = 200

/** The bytes that any ZIP may inflate to. */
private const val SMALL = 67_108_864.0
