package badlog.formats.wpilog

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe

private const val HUGE = 0xFFFFFFFFL

/** After damage, reading continues where as many records follow each other. */
private const val AFTER = 12

/** A control record that consists of [parts], between a good record of entry 1 and more of them. */
private fun around(vararg parts: ByteArray): Recording {
    val log = TestLog().start(1, "a", "double").double(1, 1_000_000, 0.0).record(0, 1_000_000, parts.fold(ByteArray(0), ByteArray::plus))
    for (i in 1..AFTER) log.double(1, 1_000_000 + 20_000L * i, i.toDouble())
    return parseLog(log.bytes)
}

private fun Recording.shouldHaveAll(count: Int = AFTER) = topics.single { it.name == "a" }.samples.toList() shouldBe (0..count).map { it.toDouble() }

/** The malformed logs at which WPILib's own readers failed before 2026's summer, each with good records before and after. */
class WpilogMalformedSpec : FunSpec({
    val start = byteArrayOf(0)
    val finish = byteArrayOf(1)
    val metadata = byteArrayOf(2)
    val id = number(2, 4)

    test("a header with a text longer than the file, or than an int, adds no topic, and takes no memory") {
        for (size in listOf(1L, 0x7FFFFFFF, 0x80000000, HUGE)) {
            val recording = parseLog("WPILOG".encodeToByteArray() + byteArrayOf(0, 1) + number(size, 4))
            withClue(size) { recording.topics to recording.problems.isEmpty() shouldBe (emptyList<Topic>() to false) }
        }
    }

    test("a header that is cut anywhere adds no topic, and the loss is reported") {
        val whole = TestLog("{}").bytes
        for (size in whole.indices) {
            val recording = parseLog(whole.copyOf(size))
            withClue(size) { recording.topics to recording.problems.isEmpty() shouldBe (emptyList<Topic>() to false) }
        }
    }

    test("a control record with texts longer than itself is dropped, and the records beside it are read") {
        val malformed = mapOf(
            "a name beyond the record" to listOf(start, id, number(100, 4), byteArrayOf(65)),
            "a name of 4 GiB" to listOf(start, id, number(HUGE, 4), byteArrayOf(65)),
            "sizes whose sum is small again" to listOf(start, id, number(0x7FFFFFFF, 4), number(0x7FFFFFFF, 4), number(8, 4)),
            "no type" to listOf(start, id, text("b")),
            "no metadata" to listOf(start, id, text("b"), text("double")),
            "a type beyond the record" to listOf(start, id, text("b"), number(9, 4), byteArrayOf(65), text("")),
            "half an id" to listOf(start, number(2, 2)),
            "nothing" to emptyList(),
            "an unknown kind" to listOf(byteArrayOf(7), id),
            "a negative kind" to listOf(byteArrayOf(-1), id),
            "metadata beyond the record" to listOf(metadata, number(1, 4), number(HUGE, 4)),
            "half a finish" to listOf(finish, number(1, 3)),
        )
        for ((what, parts) in malformed) withClue(what) { around(*parts.toTypedArray()).shouldHaveAll() }
    }

    test("control records of entries that were never started do no harm") {
        around(finish, number(77, 4)).shouldHaveAll()
        around(metadata, number(77, 4), text("{}")).shouldHaveAll()
        around(finish, number(0, 4)).shouldHaveAll()
        around(metadata, number(HUGE, 4), text("{}")).shouldHaveAll()
    }

    test("an entry may have any number but 0, the number of control records") {
        for (number in listOf(0L, 1L shl 31, HUGE)) around(start, number(number, 4), text("b"), text("double"), text("")).shouldHaveAll()
        val log = TestLog().start(-1, "b", "double").double(-1, 5, 3.0)
        parseLog(log.bytes).topics.single().samples.toList() shouldBe listOf(3.0)
    }

    test("bytes behind the last record are a cut record, whatever size they claim") {
        val good = TestLog().start(1, "a", "double").double(1, 1_000_000, 0.0).double(1, 1_020_000, 1.0).bytes
        for (trailing in listOf("00", "7f", "3c01ffffffff", "7c01000000ffffff7f0000000000000000", "300108")) {
            val bytes = trailing.chunked(2).map { it.toInt(16).toByte() }.toByteArray()
            val recording = parseLog(good + bytes)
            withClue(trailing) {
                recording.shouldHaveAll(1)
                val kinds = recording.problems.map { it.kind }
                kinds.any { it == ProblemKind.RECORD_CUT || it == ProblemKind.RECORDS_LOST } shouldBe true
            }
        }
    }

    test("arrays of texts with a count or sizes beyond the record are dropped, and the next one is read") {
        val log = TestLog().start(1, "s", "string[]")
        val bad = listOf(
            number(HUGE, 4),
            number(0x7FFFFFFF, 4),
            number(1, 4),
            number(1, 4) + number(HUGE, 4),
            number(2, 4) + text("a"),
            number(0, 4) + byteArrayOf(1),
            ByteArray(3),
        )
        bad.forEachIndexed { i, payload -> log.record(1, 1_000_000L + i, payload) }
        val recording = parseLog(log.record(1, 1_100_000, number(1, 4) + text("x")).bytes)
        recording.topics.single { it.name == "s[0]" }.texts.dictionary shouldBe listOf("x")
        recording.problems.map { it.kind to it.count } shouldContain (ProblemKind.BAD_RECORD to bad.size)
    }
})
