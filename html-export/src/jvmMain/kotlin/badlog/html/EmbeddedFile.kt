package badlog.html

/**
 * A file that is in the page.
 *
 * @property originalBytes its size.
 * @property inflatedBytes its size once inflated; the same when it was not compressed.
 * @property isCut whether it was compressed and something of it is missing.
 */
internal class EmbeddedFile(val originalBytes: Long, val inflatedBytes: Long, val isCut: Boolean)

/**
 * The second file of a log of two, whose bytes stand behind those of the first.
 *
 * @property name what it is called.
 * @property from how many bytes the first has.
 */
internal class SecondPart(val name: String, val from: Long)
