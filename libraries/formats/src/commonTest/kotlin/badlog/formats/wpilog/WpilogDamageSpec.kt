package badlog.formats.wpilog

import badlog.core.recording.ProblemKind
import badlog.core.recording.ProblemList
import badlog.formats.column.ColumnSource
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import kotlin.random.Random

/** A record as it is in a file. */
private data class Found(val id: Int, val micros: Double, val payload: List<Byte>)

/** The records that a parser reads from [bytes], by their places, and the resulting recording. */
private class ReadLog(bytes: ByteArray, piece: Int = bytes.size) {
    val records = LinkedHashMap<Long, Found>()
    val ends = HashMap<Long, Long>()
    val recording = parseLog(bytes, piece)

    init {
        val entries = WpilogEntries(ColumnSource(keepsSamples = false), ProblemList())
        val sink = object : RecordSink by entries {
            override fun record(head: RecordHead, position: Long, bytes: ByteArray, from: Int, until: Int) {
                if (!entries.read(head, bytes, until)) return
                records[position] = Found(head.id, head.micros, bytes.copyOfRange(until - head.size, until).asList())
                ends[position] = position + until - from
            }
        }
        val splitter = RecordSplitter(sink)
        for (at in bytes.indices step piece) splitter.accept(bytes, at, minOf(at + piece, bytes.size))
        splitter.finish()
    }

    fun count(kind: ProblemKind) = recording.problems.filter { it.kind == kind }.sumOf { it.count }
}

private const val DOUBLES = 12
private const val MODE = 20
private const val RAW = 21
private const val ARRAY = 22
private const val FLAG = 23

/** Some seconds of a robot: numbers at 50 Hz, and now and then a text, an array and raw bytes. */
private val ROBOT: ByteArray = TestLog("{}").apply {
    val random = Random(11)
    for (id in 1..DOUBLES) start(id, "/Drive/Motor $id", "double", "{\"unit\":\"A\"}")
    start(MODE, "Mode", "string").start(RAW, "Camera", "raw").start(ARRAY, "Axes", "double[]").start(FLAG, "DS:enabled", "boolean")
    for (row in 0 until 150) {
        val time = 8_000_000L + row * 20_000L
        for (id in 1..DOUBLES) double(id, time + id * 37, row + id / 16.0)
        if (row % 3 == 0) string(MODE, time + 900, "mode $row")
        if (row % 10 == 0) record(RAW, time + 1_000, random.nextBytes(random.nextInt(200)))
        if (row % 5 == 0) record(ARRAY, time + 1_100, doubles(row + 0.5, 1.0, 0.0))
        if (row % 25 == 0) record(FLAG, time + 1_200, byteArrayOf((row / 25 % 2).toByte()))
    }
}.bytes

private val WHOLE = ReadLog(ROBOT)

/** The places of the entries' records, behind the records that begin the entries. */
private val BODY = WHOLE.records.entries.first { it.value.id != 0 }.key.toInt()

/** The records of [WHOLE] before [from] or from [until] on. */
private fun intact(from: Int, until: Int) = WHOLE.records.filter { (at, _) -> WHOLE.ends.getValue(at) <= from || at >= until }

class WpilogDamageSpec : FunSpec({
    test("after a hole of zeros at any place, the records continue within 75 bytes, and none is invented") {
        for (from in BODY until ROBOT.size - 6000 step 61 * PLACE_STEP) {
            val until = from + 4096
            val damaged = ROBOT.copyOf().also { it.fill(0, from, until) }
            val log = ReadLog(damaged)
            val lost = intact(from, until + 75).filter { (at, record) -> log.records[at] != record }
            // A record right before the hole may end in zeros of its own.
            lost.values.filter { it.payload.last() != 0.toByte() }.shouldBeEmpty()
            (log.records.keys - WHOLE.records.keys).shouldBeEmpty()
            log.count(ProblemKind.RECORDS_SKIPPED) shouldBe 1
        }
    }

    test("skipped bytes are reported with their place and their size") {
        val from = WHOLE.records.keys.first { it > 12_000 }.toInt()
        val until = WHOLE.records.keys.first { it > 13_000 }.toInt()
        val log = ReadLog(ROBOT.copyOf().also { it.fill(-1, from, until) })
        val problem = log.recording.problems.single { it.kind != ProblemKind.NOT_DECODED }
        problem.kind shouldBe ProblemKind.RECORDS_SKIPPED
        problem.message shouldContain "$from to ${until - 1}"
        problem.loss.bytes shouldBe (until - from).toLong()
        log.records shouldBe WHOLE.records.filterKeys { it < from || it >= until }
    }

    test("random, lost and repeated bytes cost the records that they touch, and few others") {
        val random = Random(3)
        repeat(PropertyTesting.defaultIterationCount) {
            val from = random.nextInt(BODY, ROBOT.size - 3000)
            val size = random.nextInt(1, 300)
            val damaged = when (it % 3) {
                0 -> ROBOT.copyOf().also { bytes -> random.nextBytes(size).copyInto(bytes, from) }
                1 -> ROBOT.copyOf(from) + ROBOT.copyOfRange(from + size, ROBOT.size)
                else -> ROBOT.copyOf(from + size) + ROBOT.copyOfRange(from, ROBOT.size)
            }
            val log = ReadLog(damaged, 4096).records.values.toSet()
            val until = if (it % 3 == 2) from else from + size
            val lost = intact(from, until).filter { (_, record) -> record !in log }
            withClue("$it at $from, $size bytes") { lost.keys.sumOf { at -> (WHOLE.ends.getValue(at) - at).toInt() } shouldBeLessThan 1500 }
        }
    }

    test("a wrong byte in the record that starts an entry costs only this entry's records") {
        // The kind of the record that begins the third entry, and the length of the fourth one's name.
        for ((record, byte) in listOf(2 to 0, 3 to 5)) {
            val at = WHOLE.records.keys.elementAt(record)
            val begin = WHOLE.ends.getValue(at).toInt() - WHOLE.records.getValue(at).payload.size
            val log = ReadLog(ROBOT.copyOf().also { it[begin + byte] = 99 })
            log.records.size shouldBe WHOLE.records.size - 1 - 150
            log.count(ProblemKind.BAD_RECORD) shouldBe 1
            log.count(ProblemKind.UNKNOWN_ENTRY) shouldBe 150
            log.recording.problems.none { it.kind == ProblemKind.RECORDS_SKIPPED } shouldBe true
        }
    }

    test("a wrong size of a text costs at most the bytes that it claims, and rarely that") {
        val at = WHOLE.records.filterValues { it.id == MODE }.keys.elementAt(10)
        val head = ROBOT[at.toInt()].toInt()
        val sizeAt = at.toInt() + 1 + (head and 3) + 1
        for (size in listOf(1, 3, 9, 40, 127, 255)) {
            val log = ReadLog(ROBOT.copyOf().also { it[sizeAt] = size.toByte() })
            (WHOLE.records.keys - log.records.keys).filter { it !in at..at + size + 100 }.shouldBeEmpty()
        }
        // With two more bytes for the size, the following bytes are taken for the rest of the record's head.
        val longer = ReadLog(ROBOT.copyOf().also { it[at.toInt()] = (head or 8).toByte() })
        (WHOLE.records.keys - longer.records.keys).size shouldBeLessThan 12
    }

    test("the entries without a start record are listed by their numbers") {
        val third = WHOLE.records.keys.elementAt(2).toInt()
        val fifth = WHOLE.records.keys.elementAt(4).toInt()
        val log = ReadLog(ROBOT.copyOf().also { it.fill(0, third, fifth) })
        log.count(ProblemKind.UNKNOWN_ENTRY) shouldBe 300
        log.recording.problems.single { it.kind == ProblemKind.UNKNOWN_ENTRY }.message shouldContain "300 records belong to entries (numbers 3, 4)"
        log.recording.topics.size shouldBe ReadLog(ROBOT).recording.topics.size - 2
    }

    test("damage at the end of a file loses only the records there") {
        val log = ReadLog(ROBOT.copyOf().also { it.fill(0, ROBOT.size - 500, ROBOT.size) })
        log.recording.problems.map { it.kind } - ProblemKind.NOT_DECODED shouldContainExactly listOf(ProblemKind.RECORDS_LOST)
    }

    test("megabytes of damage are skipped with little memory") {
        val damaged = ROBOT.copyOf(12_000) + Random(5).nextBytes(3_000_000) + ROBOT.copyOfRange(12_000, ROBOT.size)
        val log = ReadLog(damaged, 65_536)
        log.records.size - WHOLE.records.size shouldBeLessThan 5
        WHOLE.records.size - log.records.size shouldBeLessThan 5
        log.recording.problems.sumOf { it.loss.bytes } shouldBeLessThan 3_000_200
    }

    test("the size of the pieces does not change which records are saved") {
        val random = Random(8)
        repeat(60 / PLACE_STEP) {
            val damaged = ROBOT.copyOfRange(0, 9000 + random.nextInt(4000))
            repeat(random.nextInt(1, 4)) {
                val at = random.nextInt(BODY / 2, damaged.size - 400)
                val size = random.nextInt(1, 400)
                if (random.nextBoolean()) damaged.fill(0, at, at + size) else random.nextBytes(size).copyInto(damaged, at)
            }
            val whole = ReadLog(damaged)
            for (piece in listOf(1, 7, 500, 4097)) {
                val other = ReadLog(damaged, piece)
                describeLog(other.recording) shouldBe describeLog(whole.recording)
                other.records shouldBe whole.records
            }
        }
    }
})
