package badlog.formats.wpilog

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Severity
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.math.PI

private fun TestLog.read(piece: Int = 1 shl 20): Recording = bytes.let { parseLog(it, piece) }

private fun Recording.topic(name: String) = topics.first { it.name == name }

private fun startWithMore(id: Int, name: String, type: String, more: Int) = byteArrayOf(0) + number(id.toLong(), 4) + text(name) + text(type) + text("") + ByteArray(more) { 7 }

class WpilogVariantsSpec : FunSpec({
    test("records before their schema are decoded if there is room for them, and all records after it") {
        val big = ByteArray(2000)
        val log = TestLog().start(1, "p", "struct:P[]")
        for (i in 0 until 1000) log.record(1, i * 20_000L, doubles(i.toDouble()) + big)
        log.start(2, "/.schema/struct:P", "structschema").string(2, 20_000_000L, "double x; char rest[2000]")
        for (i in 1000 until 1100) log.record(1, i * 20_000L, doubles(i.toDouble()) + big)
        val recording = log.read()
        val x = recording.topic("p[0]/x")
        x.samples.last() shouldBe 1099.0
        x.samples.takeLast(600) shouldBe List(600) { 500.0 + it }
        recording.problems.single { it.kind == ProblemKind.NOT_DECODED }.run {
            severity shouldBe Severity.NOTE
            count shouldBe 1100 - x.size
            message shouldContain "description"
        }
        (x.size in 600..1099) shouldBe true
        describeLog(parseLog(log.bytes, 777)) shouldBe describeLog(recording)
    }

    test("records without a schema are all shown by their size") {
        val log = TestLog().start(1, "p", "struct:P")
        for (i in 0 until 3000) log.record(1, i * 1000L, ByteArray(1000))
        val recording = log.read()
        recording.topic("p").samples.toList() shouldBe List(3000) { 1000.0 }
        recording.problems.map { it.kind } shouldBe listOf(ProblemKind.NOT_DECODED)
    }

    test("a start record with more bytes after its texts starts its entry") {
        for (more in listOf(1, 4, 17)) {
            val log = TestLog().record(0, 0, startWithMore(1, "a", "double", more)).double(1, 10, 1.5)
                .record(0, 20, startWithMore(2, "b", "double", more)).double(2, 30, 2.5).double(1, 40, 3.5)
            for (piece in listOf(1, 1000)) {
                val recording = log.read(piece)
                recording.topic("a").samples.toList() shouldBe listOf(1.5, 3.5)
                recording.topic("b").samples.toList() shouldBe listOf(2.5)
                recording.problems.shouldBeEmpty()
            }
        }
    }

    test("whole numbers are decoded under NetworkTables' name of their type") {
        val log = TestLog().start(1, "a", "int").start(2, "b", "int[]").start(3, "NT:/FMSInfo/MatchNumber", "int")
            .start(4, "NT:/FMSInfo/MatchType", "int").start(5, "NT:/FMSInfo/EventName", "string")
        log.record(1, 1, longs(-5)).record(2, 2, longs(1, 2)).record(3, 3, longs(12)).record(4, 3, longs(2)).string(5, 3, "MIKET")
        val recording = log.read()
        recording.topic("a").samples.toList() shouldBe listOf(-5.0)
        recording.topic("b[1]").samples.toList() shouldBe listOf(2.0)
        recording.values shouldBe listOf(Value("Event Name", "MIKET"), Value("Match Type", "Qualification"), Value("Match Number", "12"))
        val copy = ArrayList<Byte>()
        WpilogWriter(recording).write { bytes, size -> for (i in 0 until size) copy += bytes[i] }
        parseLog(copy.toByteArray()).topic("a").type shouldBe "int64"
    }

    test("the path of a Field2d is any number of poses, and no damage") {
        fun path(count: Int) = DoubleArray(3 * count) { if (it % 3 == 2) 90.0 else it / 10.0 }
        for ((name, type) in listOf("NT:/SmartDashboard/Field/traj" to null, "NT:/SmartDashboard/Auto/plan" to "NT:/SmartDashboard/Auto/.type")) {
            val log = TestLog()
            if (type != null) log.start(2, type, "string").string(2, 0, "Field2d")
            log.start(1, name, "double[]").record(1, 10, ByteArray(0)).record(1, 20, doubles(*path(100))).record(1, 30, doubles(*path(2)))
            val recording = log.read()
            recording.topics.count { "traj" in it.name || "plan" in it.name } shouldBe 300
            recording.topic("$name[99]/translation/x").samples[0] shouldBe 29.7
            recording.topic("$name[1]/translation/y").samples[1] shouldBe 0.4
            recording.topic("$name[0]/rotation/value").samples[1] shouldBe (PI / 2 plusOrMinus 1e-9)
            recording.problems.shouldBeEmpty()
        }
    }

    test("a path of more poses than are shown is a hint") {
        val recording = TestLog().start(1, "NT:/SmartDashboard/Field/traj", "double[]").record(1, 20, doubles(*DoubleArray(900))).read()
        recording.topics.size shouldBe 768
        recording.problems.map { it.kind } shouldBe listOf(ProblemKind.LONG_PATH)
        recording.isSalvaged shouldBe false
    }

    test("three numbers, and other arrays, keep their elements") {
        val log = TestLog().start(1, "NT:/SmartDashboard/Field/Robot", "double[]").start(2, "NT:/FieldRelative/list", "double[]")
        log.record(1, 1, doubles(1.0, 2.0, 90.0)).record(2, 1, doubles(1.0, 2.0, 3.0, 4.0, 5.0, 6.0))
        log.read().topics.map { it.name.substringAfterLast('/') } shouldBe
            listOf("Robot[0]", "Robot[1]", "Robot[2]", "list[0]", "list[1]", "list[2]", "list[3]", "list[4]", "list[5]")
    }

    test("many topics of an undecoded type are one hint, and their sizes are marked as sizes") {
        val log = TestLog()
        for (id in 1..378) log.start(id, "NT:\u0024pub\u0024topic$id", "msgpack").record(id, 5, ByteArray(30))
        val recording = log.start(400, "v", "double", "{\"unit\":\"B\"}").double(400, 5, 8.0).read()
        recording.problems.single().run {
            kind shouldBe ProblemKind.NOT_DECODED
            count shouldBe 378
        }
        recording.topics.map { it.isSizes }.count { it } shouldBe 378
        recording.topic("v").isSizes shouldBe false
    }
})
