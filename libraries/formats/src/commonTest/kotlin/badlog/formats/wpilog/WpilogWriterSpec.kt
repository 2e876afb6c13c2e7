package badlog.formats.wpilog

import badlog.core.analysis.LogView
import badlog.core.bag.VARIED_BAG
import badlog.core.bag.parse
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import kotlin.random.Random

/** [recording] as a WPILOG, and the content that this cannot hold. */
internal fun writeLog(recording: Recording, changesOnly: Boolean = false): Pair<ByteArray, List<Omission>> {
    var bytes = ByteArray(0)
    val omissions = WpilogWriter(recording, changesOnly).write { piece, size -> bytes += piece.copyOf(size) }
    return bytes to omissions
}

private fun Recording.topic(name: String): Topic = topics.single { it.name == name }

private fun Topic.timeList() = times?.toList()

class WpilogWriterSpec : FunSpec({
    test("the shortest log is the header, and lengths take as few bytes as they need") {
        val recording = parseLog(TestLog().start(1, "a", "int64").record(1, 1_000_000, longs(3)).bytes)
        val bytes = writeLog(recording).first
        bytes.copyOf(12).toList() shouldBe "WPILOG".encodeToByteArray().toList() + listOf<Byte>(0, 1, 19, 0, 0, 0)
        bytes.copyOfRange(bytes.size - 14, bytes.size).toList() shouldBe
            listOf<Byte>(0x20, 1, 8, 0x40, 0x42, 0x0f, 3, 0, 0, 0, 0, 0, 0, 0)
    }

    test("a bag that is written and read again has its topics, units, attributes, values and every sample") {
        val bag = parse(VARIED_BAG)
        val (bytes, omissions) = writeLog(bag)
        val log = parseLog(bytes)
        log.problems.map { it.kind } shouldBe listOf(ProblemKind.NOT_FINITE)
        log.values shouldBe bag.values
        log.topic("Arm/Angle").run {
            unit shouldBe "deg"
            timeList() shouldBe listOf(0.0, 0.02, 0.04, 0.06, 0.08, 0.1)
            // As text, because NaN does not equal NaN.
            samples.joinToString() shouldBe listOf(12.346, -1.2346e+05, Double.NaN, 1e-5, Double.NaN, 99.0).joinToString()
        }
        log.topic("Enabled").kind shouldBe TopicKind.BOOLEAN
        log.topic("Enabled").samples.toList() shouldBe listOf(0.0, 0.0, 1.0, 1.0, 1.0, 1.0)
        log.topic("Log").run {
            attributes shouldBe listOf("log")
            List(texts.size) { texts[it] } shouldBe listOf("armed, ready", "said \"go\"\ntwice", "Ω ready")
            timeList() shouldBe listOf(0.02, 0.04, 0.08)
        }
        log.topic("Time").attributes shouldBe listOf("hide")
        omissions shouldContain Omission("Arm/Angle", "Each gap starts with NaN.", 2)
        LogView.of(log).title shouldBe LogView.of(bag).title
    }

    test("a log that is written and read again is the same") {
        val log = TestLog().start(1, "/a", "double", "{\"source\":\"NT\",\"unit\":\"V\"}")
            .start(2, "b", "boolean").start(3, "s", "string")
            .start(4, "i", "int64").start(5, "f", "float").start(6, "j", "json").start(7, "none", "boolean")
        val random = Random(1014)
        for (i in 0L until 500) {
            val time = i * 1000 + random.nextLong(900)
            log.double(1, time, if (i == 7L) Double.NaN else random.nextDouble())
                .record(2, time, byteArrayOf((i % 3 / 2).toByte()))
                .string(3, time, "state ${i % 5}").record(4, time, longs(random.nextLong(-1000, 1L shl 52)))
                .record(5, time, floats(random.nextFloat())).string(6, time, "{\"i\":${i / 100}}")
        }
        val recording = parseLog(log.bytes)
        val (bytes, omissions) = writeLog(recording)
        omissions.shouldBeEmpty()
        describeLog(parseLog(bytes)) shouldBe describeLog(recording)
        describeLog(parseLog(writeLog(parseLog(bytes)).first)) shouldBe describeLog(recording)
    }

    test("with changes only, repeated samples are left out") {
        val log = TestLog().start(1, "a", "double").start(2, "s", "string")
        for ((i, value) in listOf(1.0, 1.0, 2.0, 2.0, 1.0, Double.NaN, Double.NaN, -0.0, 0.0).withIndex()) {
            log.double(1, i.toLong(), value).string(2, i.toLong(), if (i < 4) "x" else "y")
        }
        val (bytes, omissions) = writeLog(parseLog(log.bytes), changesOnly = true)
        omissions.single().count shouldBe 10
        val read = parseLog(bytes)
        read.topic("a").timeList() shouldBe listOf(0, 2, 4, 5, 7, 8).map { it / 1e6 }
        read.topic("s").timeList() shouldBe listOf(0.0, 4e-6)
    }

    test("metadata are unchanged if they show unit and attributes, even those that WPILib leaves out") {
        val log = TestLog().start(1, "messages", "string", "no JSON").start(2, "systemTime", "int64", "{ \"source\":\"x\" }")
            .start(3, "NT:/v", "double", "{\"properties\":{\"unit\":\"V\"}}").start(4, "a", "double[]", "{\"a\":[1, 2]}")
            .string(1, 1, "hello").record(2, 2, longs(1_700_000_000_000_000)).double(3, 3, 1.0).record(4, 4, doubles(1.0, 2.0))
        val before = parseLog(log.bytes)
        val after = parseLog(writeLog(before).first)
        after.topics.map { it.metadata } shouldBe before.topics.map { it.metadata }
        after.topics.map { it.unit } shouldBe before.topics.map { it.unit }
        after.topics.map { it.attributes } shouldBe before.topics.map { it.attributes }
        after.topics.map { it.type } shouldBe listOf("string", "int64", "double", "double", "double")
    }

    test("elements of arrays keep the type of their array, and whole numbers that were rounded are reported") {
        val log = TestLog().start(1, "f", "float[]").start(2, "i", "int64[]").start(3, "large", "int64")
            .record(1, 1, floats(0.1f)).record(2, 2, longs(7, -8)).record(3, 3, longs(Long.MAX_VALUE))
        val (bytes, omissions) = writeLog(parseLog(log.bytes))
        parseLog(bytes).topics.map { it.type } shouldBe listOf("float", "int64", "int64", "double")
        omissions.single { it.topic == "large" }.what shouldBe
            "All numbers are of type double, so whole numbers beyond 2^53 are rounded."
    }

    test("parts of structs, and sizes of bytes, keep their type, however often they are written") {
        val log = TestLog().start(1, "/.schema/struct:Translation2d", "structschema").start(2, "/Target", "struct:Translation2d", "{\"a\":1}")
            .start(3, "Photo", "raw").start(4, "Other", "struct:Other")
            .string(1, 1, "double x;double y").record(2, 2, doubles(1.0, 2.0)).record(3, 3, byteArrayOf(9, 8)).record(4, 4, byteArrayOf(9))
        val recording = parseLog(log.bytes)
        fun types(log: Recording) = log.topics.map { Triple(it.name, it.type, it.isSizes) }
        var written = recording
        repeat(3) {
            written = parseLog(writeLog(written).first)
            types(written) shouldBe types(recording)
        }
        types(recording).filter { it.third }.map { it.first } shouldBe listOf("Photo", "Other")
        written.topic("/Target/x").metadata shouldBe "{\"a\":1,\"badlog\":\"type struct:Translation2d\"}"
    }

    test("an element that its array lost has a gap again") {
        val log = TestLog().start(1, "a", "double[]").record(1, 1, doubles(1.0, 2.0)).record(1, 2, doubles(3.0))
            .record(1, 3, doubles(4.0)).record(1, 4, doubles(5.0, 6.0))
        val read = parseLog(writeLog(parseLog(log.bytes)).first)
        read.topic("a[1]").samples.map { it.isNaN() } shouldBe listOf(false, true, false)
    }

    test("a sparse topic has no gaps, and the events of a bag stay events") {
        val header = "{\"topics\":[{\"name\":\"t\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"n\"},{\"name\":\"e\"}]}\n"
        val read = parseLog(writeLog(parse(header + "t,n,e\n0,1,\n1,,\n2,,boom\n3,2,\n4,,\n5,,\n")).first)
        read.topic("n").samples.toList() shouldBe listOf(1.0, 2.0)
        read.topic("e").attributes shouldBe listOf("log")
    }

    test("values stay values, however often they are written") {
        val bag = parse(VARIED_BAG)
        val twice = parseLog(writeLog(parseLog(writeLog(bag).first)).first)
        twice.values shouldBe bag.values
        twice.topics.map { it.name } shouldBe bag.topics.map { it.name }
        val header = "{\"topics\":[{\"name\":\"a\"}],\"values\":[{\"name\":\"a\",\"value\":\"b\"}]}\n"
        parseLog(writeLog(parse(header + "a\nx\ny\n")).first).run {
            values.single().text shouldBe "b"
            List(topics.single().texts.size) { topics.single().texts[it] } shouldBe listOf("x", "y")
        }
    }

    test("an x axis that is not a time, begins before 0 or is finer than a microsecond is reported") {
        writeLog(parse("a,b\n1,2\n3,4\n")).run {
            second.single().what shouldBe "The x axis “Index” is not a time; one unit is written as one second."
            parseLog(first).topic("b").timeList() shouldBe listOf(0.0, 1.0)
        }
        val header = "{\"topics\":[{\"name\":\"t\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"b\"}],\"values\":[]}\n"
        writeLog(parse(header + "t,b\n-2,1\n0.0000001,2\n,3\n4,5\n")).run {
            parseLog(first).topic("b").samples.toList() shouldBe listOf(1.0, 2.0, 5.0)
            parseLog(first).topic("b").timeList() shouldBe listOf(0.0, 2.0, 6.0)
            second.map { it.count } shouldContain 1
            second.size shouldBe 4
        }
    }

    test("a recording without its samples is refused") {
        shouldThrow<IllegalArgumentException> { writeLog(parseLog(VARIED_LOG.bytes, keepSamples = false)) }
    }
})
