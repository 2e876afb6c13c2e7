package badlog.formats.driverstation

import badlog.core.bag.Mutant
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.formats.wpilog.describeLog
import badlog.formats.wpilog.parseLog
import badlog.formats.wpilog.writeLog
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.random.Random

private fun Recording.volts() = topics.single { it.name == "Driver Station/Battery Voltage" }

/** The times at which the voltages of [log] differ from [whole]. */
private fun lostIn(log: ByteArray, whole: ByteArray): List<Int> {
    val read = parseStation(log).volts()
    val at = read.times.orEmpty().toList().zip(read.samples.toList()).toMap()
    val expected = parseStation(whole).volts()
    return expected.samples.indices.filter { at[expected.times.orEmpty()[it]] != expected.samples[it] }
}

private fun DoubleArray?.orEmpty() = this ?: DoubleArray(0)

class DriverStationDamageSpec : FunSpec({
    val pair = STATION_LOG.bytes + STATION_EVENTS.bytes

    test("a hole in the records loses only the records in it, and the time continues") {
        for (block in listOf(ByteArray(0), pdp(), pdh())) {
            val whole = TestDslog().records(400, Status.BOTH_TELEOP) { block }.bytes
            val size = 14 + block.size
            for (filling in listOf(0, -1, 65)) {
                val from = 20 + 100 * size + 5
                val holed = whole.copyOf().also { it.fill(filling.toByte(), from, from + 50 * size) }
                val lost = lostIn(holed, whole)
                withClue("${block.size} filled with $filling: $lost") {
                    lost.all { it in 98..153 } shouldBe true
                    lost.size shouldBeInRange 49..54
                }
            }
        }
    }

    test("a hole in the events costs only the entries in it") {
        val whole = TestDsevents().apply { repeat(100) { entry(it * 10L, "Info number $it") } }.bytes
        val holed = whole.copyOf().also { it.fill(0, 500, 900) }
        val read = parseStation(holed)
        read.problems.map { it.kind } shouldContainExactly listOf(ProblemKind.RECORDS_SKIPPED)
        read.topics.first { it.name.endsWith("Events") }.size shouldBeInRange 84..88
    }

    test("events after a cut record are still read") {
        val log = TestDslog().records(5) { pdp() }.bytes
        for (cut in 1..38) {
            val read = parseStation(log.copyOf(log.size - cut) + STATION_EVENTS.bytes)
            withClue(cut) {
                read.volts().counts.numbers shouldBe 4
                read.topics.first { it.name.endsWith("Events") }.size shouldBe 5
                read.problems.map { it.kind } shouldContainExactly listOf(ProblemKind.RECORDS_SKIPPED)
            }
        }
    }

    test("a pair that is cut at any byte is read up to the cut, in pieces of any size") {
        val short = TestDslog().records(2).records(3) { pdp() }.bytes + STATION_EVENTS.bytes
        for (cut in 0..short.size) {
            val part = short.copyOf(cut)
            val read = describeLog(parseStation(part))
            describeLog(parseStation(part, 1)) shouldBe read
            describeLog(parseStation(part, 13)) shouldBe read
        }
        parseStation(short.copyOf(short.size - 1)).problems.map { it.kind } shouldContainExactly listOf(ProblemKind.RECORD_CUT)
    }

    test("random bytes after a good header never make the parser throw, and pieces make no difference") {
        checkAll(Arb.byteArray(Arb.int(0..300), Arb.byte())) { bytes ->
            for (header in listOf(TestDslog().bytes, TestDslog(version = 3).bytes, TestDsevents().entry(5, "Info a").bytes, TestDslog().records(3).bytes)) {
                val whole = describeLog(parseStation(header + bytes))
                describeLog(parseStation(header + bytes, 1)) shouldBe whole
                describeLog(parseStation(header + bytes, 7)) shouldBe whole
            }
            parseStation(bytes)
        }
    }

    test("after damage of any kind the parser does not throw, times stay in order, and the result can be written") {
        val random = Random(15)
        var readable = 0
        repeat(PropertyTesting.defaultIterationCount) {
            val mutant = Mutant.of(pair, random, 900)
            val whole = parseStation(mutant.bytes)
            withClue(mutant.damage) {
                describeLog(parseStation(mutant.bytes, random.nextInt(1, 60))) shouldBe describeLog(whole)
                parseStation(mutant.bytes, keepSamples = false).topics.map { it.name } shouldBe whole.topics.map { it.name }
                for (topic in whole.topics) {
                    topic.times?.size shouldBe topic.size
                    topic.times.orEmpty().toList().zipWithNext().all { (a, b) -> a <= b } shouldBe true
                }
                if (whole.sampleCount > 0) parseLog(writeLog(whole).first).isSalvaged shouldBe false
            }
            if (whole.sampleCount > 1000) readable++
        }
        readable shouldBeGreaterThan PropertyTesting.defaultIterationCount / 2
    }

    test("lengths beyond the end of the file take no memory") {
        parseStation(TestDslog().bytes + ByteArray(10) { 9 } + big(-1, 4), 1).sampleCount shouldBe 0
        parseStation(TestDsevents().bytes + big(STATION_START, 8) + big(0, 8) + big(0x7FFFFFFF, 4), 1).sampleCount shouldBe 0
    }
})
