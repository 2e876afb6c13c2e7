package badlog.formats.list

import badlog.core.bag.RecordingParser
import badlog.core.bag.describe
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.TopicKind
import badlog.core.recording.Value
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

    test("a list of AdvantageScope is read with its arrays, even if its last line has no end") {
        val recording = read("Timestamp,Key,Value\n0.5,/Pose,[1; 2; 3]\n0.5,/Mode,Auto\n0.7,/Pose,[1.5; 2; 3]\n0.9,/Pose,[]\n1,/A,true")
        recording.topics.map { it.name } shouldBe listOf("/Pose[0]", "/Pose[1]", "/Pose[2]", "/Mode", "/A")
        recording.topic("/Pose[0]").samples.take(2) shouldBe listOf(1.0, 1.5)
        recording.topic("/Pose[0]").samples[2].shouldBeNaN()
        recording.topic("/A").kind shouldBe TopicKind.BOOLEAN
        recording.problems shouldBe emptyList()
    }

    test("a list with times since 1970 begins at 0, and says when that was") {
        val recording = read("Timestamp,Name,Value\n1795832420.5,b,2\n1795832420.1234561,a,1\n-1,b,1\n1795832421.25,a,3\n")
        recording.topic("a").times?.toList() shouldBe listOf(0.0, 1.126544)
        recording.topic("b").times?.toList() shouldBe listOf(0.0, 0.376544)
        recording.values shouldBe listOf(Value("Start Time", "2026-11-28 02:20:20 UTC"))
        recording.problems.map { it.kind } shouldBe listOf(ProblemKind.TIMES_SORTED, ProblemKind.EARLY_TIMES)
        read("Timestamp,Name,Value\n20.5,a,2\n1795832420,a,1\n").values shouldBe emptyList()
    }

    test("a list that a spreadsheet saved with semicolons and decimal commas is read") {
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

    test("the samples of a topic are in order of time, regardless of the order of the lines") {
        val times = listOf(0.3, 0.1, 0.2, 0.2)
        val recording = read("Timestamp,Name,Value\n" + times.joinToString("") { "$it,a,${it * 10}\n" })
        recording.topic("a").times?.toList() shouldBe times.sorted()
        recording.topic("a").samples.toList() shouldBe listOf(1.0, 2.0, 2.0, 3.0)
        recording.problems.map { it.kind } shouldContain ProblemKind.TIMES_SORTED
    }

    test("empty values leave open whether a topic has numbers, texts or arrays, and keep their times") {
        val recording = read("Timestamp,Name,Value\n1,a,\n1,b,\n1,c,[]\n1,d,\n2,a,\n2,b,\n3,a,1;2;3\n3,b,UP\n3,c,[1; 2]\n3,d,7\n")
        recording.topics.map { it.name } shouldBe listOf("a[0]", "a[1]", "a[2]", "b", "c[0]", "c[1]", "d")
        recording.topic("a[2]").samples.last() shouldBe 3.0
        recording.topic("b").times?.toList() shouldBe listOf(1.0, 2.0, 3.0)
        List(3) { recording.topic("b").texts[it] } shouldBe listOf("", "", "UP")
        recording.topic("c[1]").samples.last() shouldBe 2.0
        recording.topic("d").times?.toList() shouldBe listOf(1.0, 3.0)
        recording.topic("d").samples[0].shouldBeNaN()
        recording.topic("d").samples[1] shouldBe 7.0
        recording.problems shouldBe emptyList()
    }

    test("empty values in both ways of writing them are texts") {
        for ((first, second) in listOf("" to "[]", "[]" to "")) {
            val recording = read("Timestamp,Name,Value\n1,a,$first\n2,a,$second\n3,a,[UP]\n")
            List(3) { recording.topic("a").texts[it] } shouldBe listOf(first, second, "[UP]")
        }
    }

    test("a topic with only empty values is shown") {
        val recording = read("Timestamp,Name,Value\n1,a,\n2,a,\n2,b,[]\n")
        recording.topics.map { it.name to it.counts.total } shouldBe listOf("a" to 2, "b" to 1)
    }

    test("a value of many digits that is not a number is a text, and is read quickly") {
        val digits = "1".repeat(1 shl 18)
        read("Timestamp,Name,Value\n1,a,${digits}x\n").topic("a").texts[0] shouldBe "${digits}x"
    }

    test("reading stops at a line that is too long, and reports it") {
        val recording = read("Timestamp,Name,Value\n1,a,5\n2,a,${"1".repeat(1 shl 24)}\n3,a,6\n")
        recording.topic("a").samples.toList() shouldBe listOf(5.0)
        recording.problems.map { it.kind to it.line } shouldBe listOf(ProblemKind.ROW_CUT to 3)
    }

    test("counting without keeping samples finds the same topics and counts") {
        val text = "Timestamp,Name,Value\n1,a,5\n2,b,x\n3,a,6\n4,c,true\n4,d,\n5,d,1;2\n5,e,\n6,e,x\n6,f,\n".encodeToByteArray()
        val counted = RecordingParser(LOG_FORMATS, keepSamples = false).run {
            accept(text)
            finish()
        }
        counted.topics.map { it.name to it.counts } shouldBe read(text).topics.map { it.name to it.counts }
    }

    test("a table with more or other titles is not a list") {
        for (titles in listOf("Timestamp,Name,Value,Unit", "Timestamp,/Arm,Value", "Time,Name,Value")) {
            read("$titles\n1,a,5,6\n").format.hasRows shouldBe true
        }
    }

    test("no bytes make it throw, and pieces make no difference") {
        val head = "Timestamp,Name,Value\n".encodeToByteArray()
        checkAll(Arb.byteArray(Arb.int(0..300), Arb.byte())) { bytes -> describe(read(head + bytes, 7)) shouldBe describe(read(head + bytes)) }
        val pieces = listOf("1", "0.5", ",", ",a,", "\"", "\n", "\r\n", "true", "[1; 2]", "[]", "1;2", "x", "\u0000", "-3", "nan")
        checkAll(Arb.list(Arb.element(pieces), 0..60).map { it.joinToString("") }) { body ->
            describe(read("Timestamp,Key,Value\n$body", 1)) shouldBe describe(read("Timestamp,Key,Value\n$body"))
        }
    }
})
