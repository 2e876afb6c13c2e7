package badlog.html

/**
 * A file that is in the page.
 *
 * @property originalBytes its size.
 * @property inflatedBytes its size once inflated; the same when it was not compressed.
 * @property isCut whether it was compressed and something of it is missing.
 */
internal class EmbeddedFile(val originalBytes: Long, val inflatedBytes: Long, val isCut: Boolean)
