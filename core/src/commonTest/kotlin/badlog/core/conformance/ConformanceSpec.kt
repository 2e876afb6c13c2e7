package badlog.core.conformance

import badlog.core.bag.BagParser
import badlog.core.recording.Recording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

class ConformanceSpec : FunSpec({
    val names = corpusFileNames().filter { it.endsWith(".bag") }.map { it.removeSuffix(".bag") }

    test("the corpus is there") {
        names.size shouldBeGreaterThan 45
    }

    for (name in names) {
        val bytes = readCorpusFile("$name.bag")
        val expected = comparable(readCorpusFile("$name.json").decodeToString())

        test("$name, whole") { jsonOf(parse(bytes, bytes.size)) shouldBe expected }
        test("$name, byte by byte") { jsonOf(parse(bytes, 1)) shouldBe expected }
        test("$name, in pieces of 7") { jsonOf(parse(bytes, 7)) shouldBe expected }
    }
})

private fun parse(bytes: ByteArray, piece: Int): Recording {
    val parser = BagParser(bytes.size.toLong())
    for (from in bytes.indices step maxOf(1, piece)) parser.accept(bytes, from, minOf(from + piece, bytes.size))
    return parser.finish()
}

private fun jsonOf(recording: Recording): String = comparable(expectationJson("", expectationOf(recording)))

/** The expectation without its description, and with NaN as a gap, see [expectationOf]. */
private fun comparable(json: String): String = json.lines()
    .filterNot { it.startsWith("  \"description\": ") }
    .joinToString("\n") { if (it.startsWith("      \"samples\": ")) it.replace("\"NaN\"", "null") else it }
