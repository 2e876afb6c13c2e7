package badlog.exporter

/**
 * A file that is embedded in the page.
 *
 * @property originalBytes the size of the file.
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
 * The second file of a log that consists of two files. Its bytes follow the bytes of the first file.
 *
 * @property name the name of the file.
 * @property from the size of the first file, in bytes.
 */
internal class SecondPart(val name: String, val from: Long)
