package badlog.exporter

/**
 * A file that is embedded in the page.
 *
 * @property originalBytes its size.
 * @property inflatedBytes its size once inflated; equal to [originalBytes] if it was not compressed.
 * @property isCut whether it was compressed and part of it is missing.
 */
internal class EmbeddedFile(val originalBytes: Long, val inflatedBytes: Long, val isCut: Boolean)

/**
 * The result of embedding a file in the page.
 *
 * @property lineSums the CRC-32 of the bytes of each line of base64.
 */
internal class Embedded(val file: EmbeddedFile, val lineSums: List<Int>)

/**
 * The second file of a log of two files. Its bytes follow the bytes of the first file.
 *
 * @property name its name.
 * @property from the number of bytes of the first file.
 */
internal class SecondPart(val name: String, val from: Long)
