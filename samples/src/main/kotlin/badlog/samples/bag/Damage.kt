package badlog.samples.bag

import java.io.ByteArrayOutputStream
import java.util.zip.GZIPOutputStream

/** What is left of [bag] when the robot loses its power while a row is written: [share] of its last row. */
fun cutInLastRow(bag: ByteArray, share: Double): ByteArray {
    val lastRow = bag.dropLast(1).lastIndexOf('\n'.code.toByte()) + 1
    return bag.copyOf(lastRow + ((bag.size - lastRow) * share).toInt())
}

/**
 * A page that the file system had reserved but not written when the power went: NULs, aligned to the page's size.
 *
 * @param at the page holds this share of the bag.
 */
fun losePage(bag: ByteArray, at: Double): ByteArray {
    val page = (bag.size * at).toInt() / PAGE * PAGE
    return bag.copyOf().also { it.fill(0, page, page + PAGE) }
}

/** A gzip stream that is never closed: what the compressor still holds, its last block and its trailer are missing. */
fun gzipNeverClosed(bag: ByteArray): ByteArray {
    val file = ByteArrayOutputStream()
    GZIPOutputStream(file).write(bag)
    return file.toByteArray()
}

private const val PAGE = 4096
