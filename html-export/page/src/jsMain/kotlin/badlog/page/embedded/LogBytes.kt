package badlog.page.embedded

import badlog.protocol.Crc32
import org.w3c.dom.Element
import org.w3c.files.Blob
import kotlin.js.Promise

/** The bytes of the log that is shown, for downloads and copies. */
internal interface LogBytes {
    /** Returns the bytes of the log's files, one after the other, exactly as they were exported or opened. */
    fun original(): Promise<Blob>

    /** Returns the log's text; [filter] may remove bytes from each chunk. Null if only the recording can be saved. */
    fun text(filter: (ByteArray) -> ByteArray): Promise<Blob>?

    /** Returns the log and the facts about it as markup for a page; null if this page already holds them. */
    fun toMarkup(): Promise<Blob>?
}

/** The log in [element] of this page, with the facts [about] it. */
internal class EmbeddedLog(private val about: About, element: Element) : LogBytes {
    private val file = EmbeddedFile(element)

    override fun original() = if (about.isCompressed) Promise.resolve(file.compressed()) else file.inflated(about.inflatedBytes)

    override fun text(filter: (ByteArray) -> ByteArray) = file.inflated(about.inflatedBytes, !about.isCompressed, filter)

    override fun toMarkup() = null
}

/** The CRC-32 of each line of an embedded file, to compare with the checksums that the exporter wrote. */
internal class LineSums {
    private val crc = Crc32()
    private val sums = ArrayList<Int>()

    /** The checksum of each complete line. */
    val all: List<Int> get() = sums

    /** Adds [bytes], the next piece of a line; [isLast] ends the line. */
    fun add(bytes: ByteArray, isLast: Boolean) {
        crc.update(bytes)
        if (!isLast) return
        add(crc.value)
        crc.reset()
    }

    /** Adds [sum], the checksum of the next line, if it was calculated elsewhere. */
    fun add(sum: Int) {
        sums += sum
    }

    /** Returns whether the checksums equal [expected]; if so, no line is missing or changed. */
    fun fit(expected: Array<Int>): Boolean = sums == expected.asList()
}
