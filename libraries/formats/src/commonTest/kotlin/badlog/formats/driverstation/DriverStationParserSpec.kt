package badlog.formats.driverstation

import badlog.core.bag.RecordingParser
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Topic
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.describeLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private fun Recording.topic(name: String) = topics.single { it.name == name }

private fun Topic.textList() = List(texts.size) { texts[it] }

private fun Recording.kinds() = problems.map { it.kind }

class DriverStationParserSpec : FunSpec({
    test("a record of version 4 has every value in its unit, every 20 ms") {
        val read = parseStation(TestDslog().record(Status.BOTH_AUTO, 12.25, trip = 17, loss = 3, cpu = 109, can = 126).record().bytes)
        read.format shouldBe DriverStationFormat
        read.problems.shouldBeEmpty()
        fun first(name: String) = read.topic("Driver Station/$name").samples.first()
        first("Battery Voltage") shouldBe 12.25
        first("CPU Utilization") shouldBe 54.5
        first("CAN Utilization") shouldBe 63.0
        first("Trip Time") shouldBe 8.5
        first("Packet Loss") shouldBe 12.0
        first("Comms Connected") shouldBe 1.0
        first("Enabled") shouldBe 1.0
        first("Brownout") shouldBe 0.0
        first("Watchdog") shouldBe 0.0
        read.topic("Driver Station/DS Mode").textList() shouldContainExactly listOf("Autonomous", "Disabled")
        read.topic("Driver Station/Robot Mode").textList() shouldContainExactly listOf("Autonomous", "Disabled")
        read.topic("Driver Station/Trip Time").run { times?.toList() to unit } shouldBe (listOf(0.0, 0.02) to "ms")
        read.values.map { "${it.name}: ${it.text}" } shouldContainExactly listOf("Start Time: 2026-03-07 15:04:05 UTC")
    }

    test("loss is a number with a sign, and between 0 and 100 %") {
        val log = listOf(-1, -2, -3, 1, 25, 26, 39).fold(TestDslog()) { log, loss -> log.record(loss = loss) }
        parseStation(log.bytes).topic("Driver Station/Packet Loss").samples.toList() shouldBe listOf(0.0, 0.0, 0.0, 4.0, 100.0, 100.0, 100.0)
    }

    test("a missing reading leaves voltage, trip time and link empty, and keeps the mode of the Driver Station") {
        val read = parseStation(TestDslog().record().record(Status.ONLY_DS_TELEOP, Double.NaN, trip = 255).record(Status.ONLY_DS_TELEOP).bytes)
        read.topic("Driver Station/Battery Voltage").counts.empty shouldBe 1
        read.topic("Driver Station/Trip Time").samples[1].isNaN() shouldBe true
        read.topic("Driver Station/Comms Connected").samples.toList() shouldBe listOf(1.0, 0.0, 1.0)
        read.topic("Driver Station/DS Mode").textList() shouldContainExactly listOf("Disabled", "Teleop", "Teleop")
        read.topic("Driver Station/Robot Mode").textList() shouldContainExactly listOf("Disabled", "No Robot Communication", "No Robot Code")
        read.problems.shouldBeEmpty()
    }

    test("values that the robot has not measured are gaps: more than 20 V is not a reading") {
        val read = parseStation(TestDslog().record(volts = Double.NaN, trip = 255).record(volts = 37.375, trip = 9).record(volts = 12.5).bytes)
        for ((name, measured) in listOf("Battery Voltage" to 12.5, "CPU Utilization" to 40.0, "CAN Utilization" to 30.0)) {
            read.topic("Driver Station/$name").run {
                samples.map { if (it.isNaN()) null else it } shouldBe listOf(null, null, measured)
                counts.empty shouldBe 2
            }
        }
        read.topic("Driver Station/Comms Connected").samples.toList() shouldBe listOf(0.0, 0.0, 1.0)
    }

    test("every channel of a PDP, with the highest bit first") {
        val read = parseStation(TestDslog().record(power = pdp { 1023 - 37 * it }).bytes)
        for (channel in 0 until 16) read.topic("PDP/Channel $channel").samples.single() shouldBe (1023 - 37 * channel) / 8.0
        read.topic("PDP/Total Current").samples.single() shouldBe (0 until 16).sumOf { (1023 - 37 * it) / 8.0 }
        read.topic("PDP/Bus Voltage").samples.single() shouldBe (12.2 plusOrMinus 1e-9)
        read.topic("PDP/Temperature").samples.single() shouldBe (23.004 plusOrMinus 0.001)
    }

    test("every channel of a PDH, with the lowest bit first, and the last four of one byte each") {
        val read = parseStation(TestDslog().record(power = pdh { if (it < 20) 1023 - 31 * it else 255 - it }).bytes)
        for (channel in 0 until 20) read.topic("PDH/Channel $channel").samples.single() shouldBe (1023 - 31 * channel) / 8.0
        for (channel in 20 until 24) read.topic("PDH/Channel $channel").samples.single() shouldBe (255 - channel) / 16.0
        read.topics.filter { it.name.startsWith("PDP") }.shouldBeEmpty()
    }

    test("channels begin, end and change with the power distribution, at their own times") {
        val read = parseStation(TestDslog().record().record(power = pdh()).record(power = pdp()).record().record().record(power = pdp()).bytes)
        read.topic("PDH/Channel 3").run { times?.toList() to samples.toList().map { it.takeIf(Double::isFinite) } } shouldBe
            (listOf(0.02, 0.04) to listOf(0.375, null))
        read.topic("PDP/Channel 3").times?.toList() shouldBe listOf(0.04, 0.06, 0.1)
        read.kinds().shouldBeEmpty()
    }

    test("a block of an unknown kind is skipped, whatever its length") {
        val read = parseStation(TestDslog().record(power = ByteArray(57) { 7 }).record(volts = 11.5).record(power = ByteArray(1)).record(volts = 11.0).bytes)
        read.topic("Driver Station/Battery Voltage").samples.toList() shouldBe listOf(12.5, 11.5, 12.5, 11.0)
        read.problems.shouldBeEmpty()
    }

    test("version 3 has records of one size, with a PDP") {
        val read = parseStation(TestDslog(version = 3).record(Status.BOTH_TELEOP, 11.0).record(volts = 12.0, power = pdp { 40 }).bytes)
        read.topic("Driver Station/Battery Voltage").samples.toList() shouldBe listOf(11.0, 12.0)
        read.topic("PDP/Channel 15").samples.toList() shouldBe listOf(15 / 8.0, 5.0)
        read.problems.shouldBeEmpty()
    }

    test("another version is refused with its number") {
        for (version in listOf(0, 2, 5)) {
            val read = parseStation(TestDslog(version).record().bytes)
            read.problems.single().message shouldContain "version $version;"
            read.isReadable shouldBe false
        }
    }

    test("entries are split into messages, oldest first, and console output is separate") {
        val read = parseStation(STATION_EVENTS.bytes)
        read.problems.shouldBeEmpty()
        read.topic("Driver Station/Console").run { textList() to attributes } shouldBe (listOf("\tfirst", "ready") to listOf("log"))
        read.topic("Driver Station/Events").textList().drop(1) shouldContainExactly listOf(
            "ERROR -200 CTR: No response at Talon FX 63\n \tat one\n\tat two",
            "Info Joystick 0: (Xbox)6 axes.",
            "Warning Rail Faults: 5V - 1.",
            "Warning 1 Loop time of 0.02s overrun",
        )
        read.topic("Driver Station/Events").times?.last() shouldBe (2.2 plusOrMinus 1e-6)
    }

    test("disk, memory, CPU and battery of roboRIO and laptop are a topic each") {
        val read = parseStation(STATION_EVENTS.bytes)
        fun only(name: String) = read.topic("Driver Station/$name").run { "${samples.single().toInt()} $unit" }
        only("roboRIO Disk Free") shouldBe "84 MB"
        only("roboRIO Memory Free") shouldBe "58 MB"
        only("Laptop CPU") shouldBe "89 %"
        only("Laptop Battery") shouldBe "100 %"
    }

    test("the match is the one that the field reports") {
        parseStation(STATION_EVENTS.bytes).values.map { "${it.name}: ${it.text}" } shouldContainExactly listOf(
            "Event Name: MILLC",
            "Match Type: Qualification",
            "Match Number: 42",
            "Replay Number: 1",
            "Start Time: 2026-03-07 15:04:05 UTC",
        )
    }

    test("records and then events are one recording, over the time of the records") {
        val log = parseStation(STATION_LOG.bytes)
        val events = parseStation(TestDsevents(STATION_START).entry(2500, "Info one").bytes)
        val both = parseStation(STATION_LOG.bytes + TestDsevents(STATION_START + 1).entry(1500, "Info one").bytes)
        both.problems.shouldBeEmpty()
        describeLog(both.copy(topics = both.topics.take(log.topics.size))) shouldBe describeLog(log)
        both.topic("Driver Station/Events").times?.toList() shouldBe events.topic("Driver Station/Events").times?.toList()
    }

    test("the content decides: records, events, and neither") {
        fun formatOf(bytes: ByteArray) = RecordingParser(LOG_FORMATS).run {
            accept(bytes)
            finish().format
        }
        formatOf(STATION_LOG.bytes) shouldBe DriverStationFormat
        formatOf(STATION_EVENTS.bytes) shouldBe DriverStationFormat
        formatOf(ByteArray(40)) shouldBe RecordingFormat.CSV
        formatOf("a,b\n1,2\n".encodeToByteArray()) shouldBe RecordingFormat.CSV
        parseStation(TestDslog().bytes).kinds() shouldContainExactly listOf(ProblemKind.NO_ROWS)
    }

    test("records beyond the limit are left out, with a problem") {
        val parser = DriverStationParser()
        parser.maxRows = 120
        val bytes = TestDslog().records(30).bytes
        parser.accept(bytes, 0, 300)
        parser.accept(bytes, 300, bytes.size)
        parser.isFull shouldBe true
        parser.finish().kinds() shouldContainExactly listOf(ProblemKind.TOO_MANY_ROWS)
    }
})
