package badlog.html

/**
 * A file that is in the page.
 *
 * @property originalBytes its size.
 * @property inflatedBytes its size once inflated; the same when it was not compressed.
 * @property isCut whether it was compressed and something of it is missing.
 * @property parts where in the gzip stream the parts begin that can be inflated by themselves, then where the last one ends;
 *   empty where it has none.
 */
internal class EmbeddedFile(val originalBytes: Long, val inflatedBytes: Long, val isCut: Boolean, val parts: List<Long> = emptyList())
