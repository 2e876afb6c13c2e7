package badlog.page.embedded

import badlog.protocol.Crc32

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
