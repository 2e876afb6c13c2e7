package badlog.exporter

/**
 * A file that is embedded in the page.
 *
 * @property originalBytes its size.
 * @property inflatedBytes its size once inflated; the same if it was not compressed.
 * @property isCut whether it was compressed and part of it is missing.
 */
internal class EmbeddedFile(val originalBytes: Long, val inflatedBytes: Long, val isCut: Boolean)

/**
 * What was written into the page of a file.
 *
 * @property lineSums the CRC-32 of the bytes of each line of base64.
 */
internal class Embedded(val file: EmbeddedFile, val lineSums: List<Int>)

/**
 * The second file of a log of two files; its bytes follow those of the first.
 *
 * @property name its name.
 * @property from the number of bytes of the first file.
 */
internal class SecondPart(val name: String, val from: Long)
