package badlog.core.conformance

import badlog.core.bag.BagParser

/** Reads a file of the corpus in pieces of [piece] bytes. Returns the recording as [comparable] JSON. */
internal fun jsonReadFrom(bytes: ByteArray, piece: Int): String {
    val parser = BagParser(bytes.size.toLong())
    val step = piece.coerceIn(1, maxOf(1, bytes.size))
    for (from in bytes.indices step step) parser.accept(bytes, from, minOf(from + step, bytes.size))
    return comparable(expectationJson("", expectationOf(parser.finish())))
}

/** The expectation without its description, and with NaN as a gap, see [expectationOf]. */
internal fun comparable(json: String): String = json.lines()
    .filterNot { it.startsWith("  \"description\": ") }
    .joinToString("\n") { if (it.startsWith("      \"samples\": ")) it.replace("\"NaN\"", "null") else it }
