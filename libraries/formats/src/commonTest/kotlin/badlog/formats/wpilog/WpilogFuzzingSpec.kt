package badlog.formats.wpilog

import badlog.core.recording.ProblemKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.random.Random

/** The kinds of problems that a file written by badlog never has. */
private val BROKEN = setOf(ProblemKind.RECORD_CUT, ProblemKind.RECORDS_LOST, ProblemKind.BAD_RECORD, ProblemKind.UNKNOWN_ENTRY)

class WpilogFuzzingSpec : FunSpec({
    test("random bytes after a good header never make the parser throw, and pieces make no difference") {
        val header = TestLog().start(1, "a", "double").start(2, "b", "string[]").start(3, "c", "struct:S[]").bytes
        checkAll(Arb.byteArray(Arb.int(0..300), Arb.byte())) { bytes ->
            val whole = describeLog(parseLog(header + bytes))
            describeLog(parseLog(header + bytes, 1)) shouldBe whole
            describeLog(parseLog(header + bytes, 7)) shouldBe whole
            parseLog(bytes)
        }
    }

    test("random records never make the parser throw, and every one is accounted for") {
        val types = listOf("double", "boolean[]", "string", "string[]", "struct:S", "struct:S[]", "json", "int64[]", "float")
        val schemas = listOf("double x", "int8 a:3; bool b:1; char c[3]", "T t[2]; enum {a=1} uint8 e", "T t", "", "junk !")
        val random = Random(1014)
        repeat(PropertyTesting.defaultIterationCount) {
            val log = TestLog().start(90, "/.schema/struct:S", "structschema").start(91, "/.schema/struct:T", "structschema")
            for (id in 1..8) log.start(id, "entry $id", types.random(random))
            var records = 10
            repeat(random.nextInt(60)) {
                when (random.nextInt(12)) {
                    0 -> log.string(random.nextInt(90, 92), 5, schemas.random(random))

                    1 -> log.start(random.nextInt(1, 10), "entry ${random.nextInt(4)}", types.random(random))

                    2 -> log.finish(random.nextInt(1, 10))

                    3 -> log.metadata(random.nextInt(1, 10), "{\"unit\":${random.nextInt()}")

                    4 -> log.record(random.nextInt(1, 9), random.nextLong(), doubles(1.0))

                    else -> {
                        val size = random.nextInt(40)
                        val payload = if (random.nextBoolean()) random.nextBytes(size) else doubles(1.0, 2.0).copyOf(size / 13 * 8)
                        log.record(random.nextInt(1, 9), random.nextLong(1, 50_000), payload)
                    }
                }
                records++
            }
            val bytes = log.bytes
            val parser = WpilogParser()
            parser.accept(bytes)
            val recording = parser.finish()
            parser.rowCount shouldBe records
            describeLog(parseLog(bytes, random.nextInt(1, 40))) shouldBe describeLog(recording)
            parseLog(bytes, keepSamples = false)
            // Every recording that was read can be written, and the written one is undamaged.
            parseLog(writeLog(recording).first).problems.none { it.kind in BROKEN } shouldBe true
            for (topic in recording.topics) {
                topic.times?.size shouldBe topic.size
                topic.samples.size shouldBe if (topic.counts.run { numbers + notFinite + truthValues } > 0) topic.size else 0
                topic.times.orEmpty().toList().zipWithNext().all { (a, b) -> a <= b } shouldBe true
            }
        }
    }

    test("a log that is cut at any byte is read up to the cut, in pieces of any size") {
        val bytes = VARIED_LOG.bytes
        var samples = 0L
        for (cut in bytes.size downTo 0 step PLACE_STEP) {
            val part = bytes.copyOf(cut)
            val recording = parseLog(part)
            describeLog(parseLog(part, 1)) shouldBe describeLog(recording)
            describeLog(parseLog(part, 13)) shouldBe describeLog(recording)
            samples = maxOf(samples, recording.sampleCount)
        }
        samples shouldBe parseLog(bytes).sampleCount
    }

    test("damage of any byte never makes the parser throw") {
        val bytes = VARIED_LOG.bytes
        val random = Random(7)
        for (at in bytes.indices step PLACE_STEP) {
            val damaged = bytes.copyOf().also { it[at] = random.nextInt().toByte() }
            describeLog(parseLog(damaged, 5)) shouldBe describeLog(parseLog(damaged))
        }
    }

    test("lengths beyond the end of the file take no memory") {
        // A payload of 16 MB in a small file, and a text of 4 GB in a record.
        val log = TestLog().start(1, "a", "string[]").record(1, 1, number(0x7FFFFFFF, 4) + number(-1, 4)).bytes
        parseLog(log + byteArrayOf(0x0C, 1, 0, 0, 0, 1, 1, 0), 1).topics.single().size shouldBe 0
        parseLog("WPILOG".encodeToByteArray() + byteArrayOf(0, 1) + number(-1, 4) + ByteArray(9)).isReadable shouldBe false
    }
})

private fun DoubleArray?.orEmpty() = this ?: DoubleArray(0)
