package badlog.formats.list

import badlog.core.bag.RecordingParser
import badlog.core.bag.describe
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.TopicKind
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

private fun read(bytes: ByteArray, piece: Int = maxOf(1, bytes.size)): Recording {
    val parser = RecordingParser(LOG_FORMATS)
    for (at in bytes.indices step piece) parser.accept(bytes, at, minOf(at + piece, bytes.size))
    return parser.finish()
}

private fun read(text: String, piece: Int = 1 shl 20) = read(text.encodeToByteArray(), piece)

private fun Recording.topic(name: String) = topics.first { it.name == name }

class ListFormatSpec : FunSpec({
    test("the list of DataLogTool becomes a topic per name, each with its own times") {
        val rows = (0 until 30).joinToString("") {
            "${it * 0.06},\"NT:/Voltage\",${12 - it / 100.0}\n${it * 0.06 + 0.02},\"NT:/State\",\"UP, SLOW\"\n${it * 0.06 + 0.04},\"DS:enabled\",${it > 5}\n"
        }
        val recording = read("Timestamp,Name,Value\n$rows")
        recording.format shouldBeSameInstanceAs ListFormat
        recording.topics.map { it.name to it.kind } shouldBe
            listOf("NT:/Voltage" to TopicKind.NUMERIC, "NT:/State" to TopicKind.STATE, "DS:enabled" to TopicKind.BOOLEAN)
        recording.topic("NT:/Voltage").samples.toList() shouldBe List(30) { 12 - it / 100.0 }
        recording.topic("NT:/Voltage").times?.toList() shouldBe List(30) { it * 0.06 }
        recording.topic("NT:/State").texts.dictionary shouldBe listOf("UP, SLOW")
        recording.problems shouldBe emptyList()
        for (piece in listOf(1, 3, 64, 65)) describe(read("Timestamp,Name,Value\n$rows", piece)) shouldBe describe(recording)
    }

    test("the list of AdvantageScope, whose last line has no end, is read with its arrays") {
        val recording = read("Timestamp,Key,Value\n0.5,/Pose,[1; 2; 3]\n0.5,/Mode,Auto\n0.7,/Pose,[1.5; 2; 3]\n0.9,/Pose,[]\n1,/A,true")
        recording.topics.map { it.name } shouldBe listOf("/Pose[0]", "/Pose[1]", "/Pose[2]", "/Mode", "/A")
        recording.topic("/Pose[0]").samples.take(2) shouldBe listOf(1.0, 1.5)
        recording.topic("/Pose[0]").samples[2].shouldBeNaN()
        recording.topic("/A").kind shouldBe TopicKind.BOOLEAN
        recording.problems shouldBe emptyList()
    }

    test("a list that a spreadsheet saved with semicolons and decimal commas is one, too") {
        val recording = read("\uFEFF\"Timestamp\";\"Name\";\"Value\"\r\n0,5;a;1,25\r\n0,7;a;1,5\r\n")
        recording.topic("a").times?.toList() shouldBe listOf(0.5, 0.7)
        recording.topic("a").samples.toList() shouldBe listOf(1.25, 1.5)
    }

    test("a text in quotes is a text, though it looks like a number, with doubled quotes and newlines") {
        val recording = read("Timestamp,Name,Value\n1,\"v\",\"12\"\n2,\"a,\"\"b\",\"one,\"\"two\"\"\nthree\"\n")
        recording.topic("v").texts[0] shouldBe "12"
        recording.topic("a,\"b").texts[0] shouldBe "one,\"two\"\nthree"
    }

    test("lines without a time or a value, and texts among numbers, are reported") {
        val recording = read("Timestamp,Name,Value\n1,a,5\nx,a,6\n2,a\n3,a,oops\n4,a,7\n")
        recording.topic("a").samples.filter { it.isFinite() } shouldBe listOf(5.0, 7.0)
        recording.problems.single { it.kind == ProblemKind.ROW_CUT }.run { line to count } shouldBe (3 to 2)
        recording.problems.single { it.kind == ProblemKind.TEXT_IN_NUMBERS }.line shouldBe 5
    }

    test("the samples of a topic are in order of time, whatever the order of the lines") {
        val times = listOf(0.3, 0.1, 0.2, 0.2)
        val recording = read("Timestamp,Name,Value\n" + times.joinToString("") { "$it,a,${it * 10}\n" })
        recording.topic("a").times?.toList() shouldBe times.sorted()
        recording.topic("a").samples.toList() shouldBe listOf(1.0, 2.0, 2.0, 3.0)
        recording.problems.map { it.kind } shouldContain ProblemKind.TIMES_SORTED
    }

    test("counting without keeping samples finds the same topics and counts") {
        val text = "Timestamp,Name,Value\n1,a,5\n2,b,x\n3,a,6\n4,c,true\n5,d,1;2\n".encodeToByteArray()
        val counted = RecordingParser(LOG_FORMATS, keepSamples = false).run {
            accept(text)
            finish()
        }
        counted.topics.map { it.name to it.counts } shouldBe read(text).topics.map { it.name to it.counts }
    }

    test("a table with such titles and more, or others, is a table") {
        for (titles in listOf("Timestamp,Name,Value,Unit", "Timestamp,/Arm,Value", "Time,Name,Value")) {
            read("$titles\n1,a,5,6\n").format.hasRows shouldBe true
        }
    }

    test("no bytes break it, and pieces make no difference") {
        val head = "Timestamp,Name,Value\n".encodeToByteArray()
        checkAll(Arb.byteArray(Arb.int(0..300), Arb.byte())) { bytes -> describe(read(head + bytes, 7)) shouldBe describe(read(head + bytes)) }
        val pieces = listOf("1", "0.5", ",", ",a,", "\"", "\n", "\r\n", "true", "[1; 2]", "1;2", "x", "\u0000", "-3", "nan")
        checkAll(Arb.list(Arb.element(pieces), 0..60).map { it.joinToString("") }) { body ->
            describe(read("Timestamp,Key,Value\n$body", 1)) shouldBe describe(read("Timestamp,Key,Value\n$body"))
        }
    }
})
