package badlog.formats

import badlog.core.analysis.LogView
import badlog.core.analysis.periodicTimes
import badlog.core.analysis.resampled
import badlog.core.analysis.samplesBetween
import badlog.core.analysis.timesOf
import badlog.core.bag.RecordingWriter
import badlog.core.bag.parse
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TopicKind
import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.wpilog.TestLog
import badlog.formats.wpilog.VARIED_LOG
import badlog.formats.wpilog.parseLog
import badlog.formats.wpilog.writeLog
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

private fun csv(text: TestLog, vararg times: Double): String {
    val out = StringBuilder()
    RecordingWriter(resampled(parseLog(text.bytes), times), RecordingFormat.CSV)
        .write { bytes, size -> out.append(bytes.decodeToString(0, size)) }
    return out.toString()
}

class ResamplingSpec : FunSpec({
    test("each row has the last value at or before it, and nothing before the first") {
        val log = TestLog().start(1, "a", "double").start(2, "on", "boolean")
            .double(1, 1_000_000, 1.5).double(1, 2_000_000, 2.5).double(1, 2_500_000, Double.NaN).double(1, 2_600_000, 3.5)
            .record(2, 2_000_000, byteArrayOf(1))
        csv(log, 0.5, 1.0, 2.0, 2.5, 9.0) shouldBe "Time,a,on\n0.5,,\n1,1.5,\n2,2.5,true\n2.5,,true\n9,3.5,true\n"
    }

    test("times of a period have the digits that a person would write") {
        val log = TestLog().start(1, "a", "double").double(1, 13_359, 1.0).double(1, 90_000_000, 2.0)
        val times = periodicTimes(parseLog(log.bytes), 0.02)
        times.size shouldBe 4501
        times.forEachIndexed { row, time -> time shouldBe (13_359 + row * 20_000L) / 1e6 }
        (times.last() >= 90.0) shouldBe true
    }

    test("states hold, an event is in one row, and several events of one row are joined") {
        val log = TestLog().start(1, "mode", "string").start(2, "messages", "string")
            .string(1, 1_000_000, "auto").string(1, 3_000_000, "teleop")
            .string(2, 1_100_000, "one").string(2, 1_200_000, "two").string(2, 3_500_000, "one")
        csv(log, 1.0, 2.0, 3.0, 4.0) shouldBe "Time,mode,messages\n1,auto,\n2,auto,one; two\n3,teleop,\n4,teleop,one\n"
    }

    test("the result is a bag that reads as the same") {
        val recording = resampled(parseLog(VARIED_LOG.bytes), periodicTimes(parseLog(VARIED_LOG.bytes), 0.02))
        var bytes = ByteArray(0)
        RecordingWriter(recording).write { piece, size -> bytes += piece.copyOf(size) }
        val read = parse(bytes)
        read.rowCount shouldBe recording.rowCount
        read.topics.map { it.name } shouldBe recording.topics.map { it.name }
        for ((one, other) in read.topics.zip(recording.topics)) {
            one.counts.copy(gaps = 0) shouldBe other.counts.copy(gaps = 0)
            one.unit shouldBe other.unit
        }
        LogView.of(read).xAxis.title shouldBe "Time (s)"
        recording.topics.single { it.name == "messages" }.kind shouldBe TopicKind.EVENT
    }

    test("a bag is resampled by its x axis, which the new one replaces") {
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"b","unit":"V"}],"values":[]}""" + "\n"
        val bag = parse(header + "Time,b\n0,1\n1,2\n0.5,3\n2,4\n")
        val result = resampled(bag, doubleArrayOf(0.0, 0.6, 1.0, 5.0))
        result.topics.map { it.name } shouldBe listOf("Time (2)", "b")
        result.topics[1].samples.toList() shouldBe listOf(1.0, 3.0, 2.0, 4.0)
    }

    test("a bag that became a WPILOG has its x axis again, in its own unit and digits") {
        for ((unit, x) in listOf("s" to listOf(0.0, 0.0200000001, 0.04), "ms" to listOf(0.0, 20.0001, 40.0))) {
            val header = """{"topics":[{"name":"b","unit":"V"},{"name":"T","unit":"$unit","attrs":["xaxis"]}],"values":[]}""" + "\n"
            val bag = parse(header + "b,T\n" + x.joinToString("") { "1,$it\n" })
            val log = parseLog(writeLog(bag).first)
            val result = resampled(log, timesOf(log, log.topics[1]))
            result.topics.map { it.name } shouldBe listOf("b", "T")
            result.topics[1].samples.toList() shouldBe x
            result.topics[1].attributes shouldBe listOf("xaxis")
            result.topics[1].unit shouldBe unit
            resampled(log, doubleArrayOf(0.03)).topics[1].samples.single() shouldBe if (unit == "s") 0.03 else 30.0
        }
    }

    test("a sample that rounding puts after its row stays in that row, and none is lost") {
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"b","unit":"V"}],"values":[]}""" + "\n"
        checkAll(Arb.double(0.0, 1000.0).filter { it.isFinite() }, Arb.element(0.005, 0.01, 0.02, 0.1), Arb.int(1, 2000)) { start, period, count ->
            // As a reader calculates the times of records that have none.
            val times = DoubleArray(count) { start + it * period }
            val bag = parse(header + "Time,b\n" + List(count) { "$it,$it\n" }.joinToString(""))
            val topics = listOf(bag.topics[1].copy(times = times))
            val log = bag.copy(format = DriverStationFormat, headerLine = null, topics = topics, rowCount = 0)
            val rows = periodicTimes(log, period)
            resampled(log, rows).topics[1].samples.toList() shouldBe List(count) { it.toDouble() }
            samplesBetween(log.topics[0], rows) shouldBe 0
        }
    }

    test("a topic that was sparse in a bag is sparse again: each sample is in one row, and rows between are empty") {
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"seen","unit":"m"},{"name":"on"}],"values":[]}""" + "\n"
        checkAll(Arb.list(Arb.boolean(), 1..200)) { seen ->
            val rows = seen.indices.joinToString("") { row -> "${row * 0.02},${if (seen[row] && row % 3 == 0) row else ""},${if (row % 4 == 1) seen[row] else ""}\n" }
            val bag = parse(header + "Time,seen,on\n" + rows)
            val log = parseLog(writeLog(bag).first)
            val again = resampled(log, timesOf(log, log.topics[0]))
            for ((one, other) in again.topics.zip(bag.topics)) {
                if (other.isSparse && other.kind != TopicKind.EMPTY) one.samples.map { it.toString() } shouldBe other.samples.map { it.toString() }
            }
        }
    }

    test("of several samples of a sparse topic before one row, the row has the last, and the others count as lost") {
        val log = TestLog().start(1, "a", "double").start(2, "seen", "double", "{\"badlog\":\"sparse\"}")
        for (row in 0L..9) log.double(1, row * 20_000, 1.0)
        log.double(2, 20_000, 5.0).double(2, 110_000, 6.0).double(2, 115_000, 7.0)
        val recording = parseLog(log.bytes)
        val times = periodicTimes(recording, 0.02)
        val seen = resampled(recording, times).topics.single { it.name == "seen" }
        seen.samples.withIndex().filter { !it.value.isNaN() }.map { it.index to it.value } shouldBe listOf(1 to 5.0, 6 to 7.0)
        seen.isSparse shouldBe true
        samplesBetween(recording.topics.single { it.name == "seen" }, times) shouldBe 1
    }

    test("the times of a period begin at the first sample and reach the last one") {
        val log = parseLog(TestLog().start(1, "a", "double").double(1, 1_000_000, 1.0).double(1, 1_300_000, 1.0).bytes)
        periodicTimes(log, 0.1).size shouldBe 4
        periodicTimes(log, 1.0).toList() shouldBe listOf(1.0, 2.0)
        periodicTimes(parseLog(TestLog().bytes), 1.0).size shouldBe 0
        shouldThrow<IllegalArgumentException> { periodicTimes(log, 0.0) }
        shouldThrow<IllegalArgumentException> { periodicTimes(log, 1e-12) }
        shouldThrow<IllegalArgumentException> { resampled(log, doubleArrayOf(1.0, 1.0)) }
    }

    test("each time of a topic occurs once, in order") {
        val log = TestLog().start(1, "a", "double")
        for (time in listOf(5L, 3, 5, 4, 3)) log.double(1, time * 1_000_000, 1.0)
        val recording = parseLog(log.bytes)
        timesOf(recording, recording.topics[0]).toList() shouldBe listOf(3.0, 4.0, 5.0)
        resampled(recording, timesOf(recording, recording.topics[0])).rowCount shouldBe 3
    }
})
