package badlog.formats.wpilog

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeSameInstanceAs

private fun TestLog.read() = parseLog(bytes)

private fun Recording.topic(name: String): Topic = topics.single { it.name == name }

private fun Topic.timeList() = times?.toList()

private fun Topic.textList() = List(texts.size) { texts[it] }

private fun Recording.count(kind: ProblemKind) = problems.filter { it.kind == kind }.sumOf { it.count }

class WpilogParserSpec : FunSpec({
    test("numbers and truth values keep their own times, in s") {
        val recording = TestLog()
            .start(1, "/Arm/Angle", "double").start(2, "f", "float").start(3, "i", "int64").start(4, "b", "boolean")
            .double(1, 20_000, 1.5).double(1, 1_000_001, -2.0)
            .record(2, 3, floats(0.25f)).record(3, 1_000_000, longs(3))
            .record(4, 5, byteArrayOf(1)).record(4, 6, byteArrayOf(0))
            .read()
        recording.format shouldBe WpilogFormat
        recording.rowCount shouldBe 0
        recording.sampleCount shouldBe 6L
        recording.problems.shouldBeEmpty()
        recording.topics.map { it.name } shouldContainExactly listOf("/Arm/Angle", "f", "i", "b")
        recording.topic("/Arm/Angle").run {
            timeList() shouldBe listOf(0.02, 1.000001)
            samples.toList() shouldBe listOf(1.5, -2.0)
            kind shouldBe TopicKind.NUMERIC
            type shouldBe "double"
        }
        recording.topic("f").samples.toList() shouldBe listOf(0.25)
        recording.topic("i").samples.toList() shouldBe listOf(3.0)
        recording.topic("b").kind shouldBe TopicKind.BOOLEAN
        recording.topic("b").samples.toList() shouldBe listOf(1.0, 0.0)
    }

    test("elements of an array are topics that share their times") {
        val recording = TestLog().start(1, "axes", "float[]").start(2, "flags", "boolean[]").start(3, "n", "int64[]")
            .record(1, 1, floats(1f, 2f)).record(1, 2, floats(3f, 4f))
            .record(2, 1, byteArrayOf(1, 0)).record(3, 1, longs(-1, 7)).read()
        recording.topics.map { it.name } shouldContainExactly
            listOf("axes[0]", "axes[1]", "flags[0]", "flags[1]", "n[0]", "n[1]")
        recording.topic("axes[1]").samples.toList() shouldBe listOf(2.0, 4.0)
        recording.topic("axes[0]").times.shouldNotBeNull() shouldBeSameInstanceAs recording.topic("axes[1]").times
        recording.topic("flags[0]").kind shouldBe TopicKind.BOOLEAN
        recording.topic("n[0]").samples.toList() shouldBe listOf(-1.0)
    }

    test("an element that disappears has one gap, and only its own samples") {
        val log = TestLog().start(1, "a", "double[]").record(1, 1, doubles(1.0, 10.0))
        for (i in 2L..50L) log.record(1, i, doubles(1.0))
        log.record(1, 51, doubles(1.0, 11.0, 12.0)).record(1, 52, ByteArray(0))
        val recording = log.read()
        recording.topic("a[0]").size shouldBe 52
        recording.topic("a[1]").run {
            timeList() shouldBe listOf(0.000001, 0.000002, 0.000051, 0.000052)
            samples.map { if (it.isNaN()) null else it } shouldBe listOf(10.0, null, 11.0, null)
            counts.empty shouldBe 2
            counts.gaps shouldBe 2
        }
        recording.topic("a[2]").timeList() shouldBe listOf(0.000051, 0.000052)
    }

    test("an array that is too long loses its end, and that is reported") {
        val recording = TestLog().start(1, "a", "boolean[]").record(1, 1, ByteArray(1000)).read()
        recording.topics.size shouldBe 256
        recording.count(ProblemKind.TOO_MANY_TOPICS) shouldBe 744
    }

    test("texts that repeat or are few are states, many different ones are events") {
        val log = TestLog().start(1, "mode", "string").start(2, "log", "string").start(3, "messages", "string")
        for (i in 0L..20L) log.string(1, i, if (i % 2 == 0L) "auto" else "teleop").string(2, i, "event $i")
        log.start(4, "console", "string").string(4, 5, "Loop time of 0.02s overrun").string(4, 6, "Loop time of 0.02s overrun")
        val recording = log.string(3, 5, "hello").read()
        recording.topic("console").attributes shouldBe listOf("log")
        recording.topic("mode").kind shouldBe TopicKind.STATE
        recording.topic("log").kind shouldBe TopicKind.EVENT
        recording.topic("messages").attributes shouldBe listOf("log")
        recording.topic("mode").texts.dictionary shouldBe listOf("auto", "teleop")
        recording.topic("log").textList().last() shouldBe "event 20"
    }

    test("texts of an array are topics, too") {
        val recording = TestLog().start(1, "options", "string[]")
            .record(1, 9, number(2, 4) + text("one") + text("")).record(1, 10, number(1, 4) + text("two")).read()
        recording.topic("options[0]").textList() shouldBe listOf("one", "two")
        recording.topic("options[1]").run {
            textList() shouldBe listOf("")
            timeList() shouldBe listOf(0.000009, 0.00001)
            counts.empty shouldBe 1
        }
    }

    test("an undecoded record is shown by its size, JSON by its text") {
        val recording = TestLog().start(1, "p", "proto:Pose").start(2, "r", "raw")
            .start(3, "j", "json").start(4, "s", "struct:No")
            .record(1, 1, ByteArray(5)).record(2, 1, ByteArray(0)).string(3, 1, "{\"a\":1}").record(4, 1, ByteArray(24)).read()
        recording.topic("p").run {
            unit shouldBe "B"
            samples.toList() shouldBe listOf(5.0)
        }
        recording.topic("s").samples.toList() shouldBe listOf(24.0)
        recording.topic("j").textList() shouldBe listOf("{\"a\":1}")
        recording.count(ProblemKind.NOT_DECODED) shouldBe 3
    }

    test("metadata has units, the last one counts, and badlog's own attributes are restored") {
        val recording = TestLog().start(1, "a", "double", "{\"unit\":\"V\"}")
            .start(2, "b", "double", "{\"properties\":{\"unit\":\"A\"}}")
            .start(3, "c", "double", "not JSON").metadata(3, "{\"unit\":\"m\",\"attrs\":[\"zero\"]}").read()
        recording.topics.map { it.unit } shouldBe listOf("V", "A", "m")
        recording.topic("c").attributes shouldBe listOf("zero")
        recording.topic("a").metadata shouldBe "{\"unit\":\"V\"}"
    }

    test("a number that is used again belongs to the new entry, and the topic of the same name continues") {
        val recording = TestLog().start(1, "a", "double").double(1, 1, 1.0).finish(1).double(1, 2, 9.0)
            .start(1, "b", "double").double(1, 3, 2.0)
            .start(2, "a", "double").double(2, 4, 3.0).start(3, "a", "int64").record(3, 5, longs(4)).read()
        recording.topic("a").samples.toList() shouldBe listOf(1.0, 3.0)
        recording.topic("b").samples.toList() shouldBe listOf(2.0)
        recording.topic("a (2)").samples.toList() shouldBe listOf(4.0)
        recording.count(ProblemKind.UNKNOWN_ENTRY) shouldBe 1
        recording.count(ProblemKind.DUPLICATE_TOPIC) shouldBe 1
    }

    test("entries may have large numbers") {
        val recording = TestLog().start(-2, "a", "double").double(-2, 1, 1.0)
            .start(5_000_000, "b", "double").double(5_000_000, 1, 2.0)
            .finish(-2).double(-2, 2, 3.0).read()
        recording.topics.map { it.samples.toList() } shouldBe listOf(listOf(1.0), listOf(2.0))
    }

    test("times in any order are sorted, equal ones stay in the order of the file") {
        val log = TestLog().start(1, "a", "double").start(2, "s", "string").start(3, "v", "double[]")
        for ((i, time) in listOf(5L, 3, 5, 1, 3, 9).withIndex()) {
            log.double(1, time, i.toDouble()).string(2, time, "$i").record(3, time, doubles(i.toDouble(), -i.toDouble()))
        }
        val recording = log.read()
        recording.topic("a").samples.toList() shouldBe listOf(3.0, 1.0, 4.0, 0.0, 2.0, 5.0)
        recording.topic("s").textList() shouldBe listOf("3", "1", "4", "0", "2", "5")
        recording.topic("v[1]").samples.toList() shouldBe listOf(-3.0, -1.0, -4.0, -0.0, -2.0, -5.0)
        recording.topic("v[1]").timeList() shouldBe recording.topic("a").timeList()
        recording.problems.map { it.kind }.toSet() shouldBe setOf(ProblemKind.TIMES_SORTED)
    }

    test("records from before the robot's clock began hold from the recording's start, in their own order") {
        val log = TestLog().start(1, "a", "double").start(2, "camera", "string").start(3, "v", "double[]")
            .double(1, 3_000_000, 3.0).double(1, -1_000, 2.0).double(1, -585_000_000, 1.0).double(1, 2_000_000, 2.5)
            .string(2, -7_000_000, "there").record(3, -1, doubles(1.0)).record(3, 9_000_000, doubles(2.0))
        val recording = log.read()
        recording.topic("a").timeList() shouldBe listOf(2.0, 2.0, 2.0, 3.0)
        recording.topic("a").samples.toList() shouldBe listOf(1.0, 2.0, 2.5, 3.0)
        recording.topic("camera").timeList() shouldBe listOf(2.0)
        recording.topic("camera").textList() shouldBe listOf("there")
        recording.topic("v[0]").timeList() shouldBe listOf(2.0, 9.0)
        recording.count(ProblemKind.EARLY_TIMES) shouldBe 4
        recording.isSalvaged shouldBe false
        TestLog().start(1, "a", "double").double(1, -5, 1.0).read().topic("a").timeList() shouldBe listOf(0.0)
    }

    test("impossible times, and times days away, are dropped and counted") {
        val log = TestLog().start(1, "a", "double").double(1, Long.MIN_VALUE, 1.0).double(1, 1_700_000_000_000_000, 2.0)
        for (i in 1L..9L) log.double(1, i * 1_000_000, i.toDouble())
        val recording = log.double(1, 1L shl 60, 1.0).read()
        recording.topic("a").timeList() shouldBe (1..9).map { it.toDouble() }
        recording.topic("a").counts.numbers shouldBe 9
        recording.count(ProblemKind.WILD_TIMES) shouldBe 3
        recording.isSalvaged shouldBe true
    }

    test("a log of an hour is complete, whenever it began") {
        val begin = 26_000_000_000_000
        val recording = TestLog().start(1, "a", "double").double(1, begin, 1.0).double(1, begin + 3_600_000_000, 2.0).read()
        recording.topic("a").timeList() shouldBe listOf(26_000_000.0, 26_003_600.0)
        recording.problems.shouldBeEmpty()
    }

    test("a cut last record is dropped, and all records before it are read") {
        val whole = TestLog().start(1, "a", "double").double(1, 1, 1.0).double(1, 2, 2.0).bytes
        for (cut in 1..11) {
            val recording = parseLog(whole.copyOf(whole.size - cut))
            recording.topic("a").samples.toList() shouldBe listOf(1.0)
            recording.problems.single().kind shouldBe ProblemKind.RECORD_CUT
        }
    }

    test("after nonsense nothing can be read, and the lost bytes are counted") {
        val good = TestLog().start(1, "a", "double").double(1, 1, 1.0)
        val end = good.bytes.size
        // Two of them look like records of entries that do not exist.
        val log = good.raw(0x00, 0x20, 0x00, 0x05).raw(0x00, 0x21, 0x00, 0x05).raw(0xFF, 0xFF, 0x01).double(1, 2, 2.0)
        val recording = log.read()
        recording.topic("a").samples.toList() shouldBe listOf(1.0)
        recording.problems.map { it.kind } shouldBe listOf(ProblemKind.RECORDS_LOST)
        recording.problems[0].message shouldContain "The last bytes of the file, $end to ${log.bytes.size - 1}, "
        TestLog().start(1, "a", "double").double(1, 1, 1.0).raw(*IntArray(50)).read().problems.map { it.kind } shouldBe
            listOf(ProblemKind.RECORDS_LOST)
    }

    test("a record that does not fit its type is dropped and counted") {
        val recording = TestLog().start(1, "a", "double").start(2, "v", "double[]").start(3, "s", "string[]")
            .record(1, 1, ByteArray(7)).record(2, 1, ByteArray(9)).record(3, 1, number(3, 4)).record(3, 2, number(-1, 4))
            .record(3, 2, number(0, 4) + 1).double(1, 2, 2.0).read()
        recording.topic("a").samples.toList() shouldBe listOf(2.0)
        recording.count(ProblemKind.BAD_RECORD) shouldBe 5
    }

    test("entries without records and empty arrays are listed") {
        val recording = TestLog().start(1, "a", "double").start(2, "v", "double[]").record(2, 1, ByteArray(0)).read()
        recording.topics.map { it.kind } shouldBe listOf(TopicKind.EMPTY, TopicKind.EMPTY)
        recording.topic("v").counts.empty shouldBe 1
    }

    test("the match and the time of day come from WPILib's entries") {
        val log = TestLog().start(1, "NT:/FMSInfo/EventName", "string").start(2, "NT:/FMSInfo/MatchNumber", "int64")
            .start(3, "NT:/FMSInfo/MatchType", "int64").start(4, "systemTime", "int64")
            .string(1, 1, "").string(1, 2_000_000, "OHCL").record(2, 1, longs(42)).record(3, 1, longs(2))
            .record(4, 3_000_001, longs(1_709_992_953_000_000))
            .start(5, "NT:/FMSInfo/IsRedAlliance", "boolean").record(5, 1, byteArrayOf(1)).record(5, 2, byteArrayOf(0))
        for (keepSamples in listOf(true, false)) {
            parseLog(log.bytes, keepSamples = keepSamples).values.associate { it.name to it.text } shouldBe mapOf(
                "Event Name" to "OHCL",
                "Match Type" to "Qualification",
                "Match Number" to "42",
                "Alliance" to "Blue",
                "Start Time" to "2024-03-09 14:02:30 UTC",
            )
        }
    }

    test("off the field, the alliance is ignored") {
        val log = TestLog().start(1, "DriverStation/AllianceStation", "int64").record(1, 1, longs(2))
        log.read().values shouldBe emptyList()
        log.start(2, "DriverStation/MatchNumber", "int64").record(2, 2, longs(7)).read().values.map { it.text } shouldBe listOf("7", "Red")
    }

    test("a file that is not a WPILOG, or has another version, is refused with the reason") {
        parseLog("Time,a\n1,2\n".encodeToByteArray()).problems.single().kind shouldBe ProblemKind.NOT_A_RECORDING
        parseLog("WPILOG".encodeToByteArray() + byteArrayOf(0, 2, 0, 0, 0, 0)).isReadable shouldBe false
        parseLog("WPILOG".encodeToByteArray()).problems.map { it.kind } shouldContain ProblemKind.RECORD_CUT
    }

    test("without samples, the counts are the same and no values are kept") {
        val kept = VARIED_LOG.read()
        val counted = parseLog(VARIED_LOG.bytes, keepSamples = false)
        counted.topics.map { it.name to it.counts } shouldBe kept.topics.map { it.name to it.counts }
        counted.topics.all { it.samples.isEmpty() && it.texts.size == 0 && it.times?.size == 0 } shouldBe true
        counted.problems.map { it.kind }.toSet() + ProblemKind.TIMES_SORTED shouldBe kept.problems.map { it.kind }.toSet()
    }

    test("a number takes 16 bytes at most, whatever its type is") {
        val log = TestLog().start(1, "a", "double").start(2, "v", "double[]").start(3, "b", "boolean")
        for (i in 1L..5000L) {
            log.double(1, i, 1.0).record(2, i, doubles(*DoubleArray((i % 7).toInt()))).record(3, i, byteArrayOf(1))
        }
        val topics = log.read().topics
        val arrays = topics.map { it.samples } + topics.mapNotNull { it.times }
        val kept = arrays.filterIndexed { i, array -> arrays.indexOfFirst { it === array } == i }.sumOf { it.size * 8 }
        (kept <= 16 * topics.sumOf { it.size }) shouldBe true
    }

    test("records beyond the limit are not read, which is reported, and the parser shows that it is full") {
        val log = TestLog().start(1, "a", "double")
        repeat(300_000) { log.double(1, it.toLong(), 1.0) }
        val parser = WpilogParser().apply { maxRows = 1000 }
        parser.accept(log.bytes)
        parser.isFull shouldBe true
        val recording = parser.finish()
        recording.problems.single().run {
            kind shouldBe ProblemKind.TOO_MANY_ROWS
            message shouldContain "more than 1000 records"
        }
        (recording.topic("a").size in 1000..100_000) shouldBe true
        WpilogParser().apply { maxRows = 300_001 }.run {
            accept(log.bytes)
            finish().problems.shouldBeEmpty()
        }
    }

    test("an absurd number of topics does not fill the memory") {
        val log = TestLog()
        for (id in 1..300) log.start(id, "$id", "boolean[]").record(id, 1, ByteArray(256))
        val recording = log.read()
        recording.topics.count { it.size > 0 } shouldBe 65_536
        recording.count(ProblemKind.TOO_MANY_TOPICS) shouldBe 300 - 256
    }
})
