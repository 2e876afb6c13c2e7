package badlog.samples.bag

import java.io.ByteArrayOutputStream
import java.util.zip.GZIPOutputStream

/** Returns [bag] after a power cut during the last row: [share] of that row is left. */
fun cutInLastRow(bag: ByteArray, share: Double): ByteArray {
    val lastRow = bag.dropLast(1).lastIndexOf('\n'.code.toByte()) + 1
    return bag.copyOf(lastRow + ((bag.size - lastRow) * share).toInt())
}

/**
 * Returns [bag] with a page that was reserved but not written at a power cut. The page is filled with NULs, and aligned to its size.
 *
 * @param at the position of the page, as a share of the bag.
 */
fun losePage(bag: ByteArray, at: Double): ByteArray {
    val page = (bag.size * at).toInt() / PAGE * PAGE
    return bag.copyOf().also { it.fill(0, page, page + PAGE) }
}

/** Returns [bag] as a gzip stream that is never closed. The compressor's buffer, the last block and the trailer are missing. */
fun gzipNeverClosed(bag: ByteArray): ByteArray {
    val file = ByteArrayOutputStream()
    GZIPOutputStream(file).write(bag)
    return file.toByteArray()
}

private const val PAGE = 4096
