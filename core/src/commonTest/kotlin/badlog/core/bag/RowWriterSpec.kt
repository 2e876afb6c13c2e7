package badlog.core.bag

import badlog.core.number.FiveDigitFormat
import badlog.core.recording.ProblemKind
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

private fun RowWriter.written(): String = bytes.decodeToString(0, size)

class RowWriterSpec : FunSpec({
    test("a header and its rows are the lines of a bag") {
        val header = BagHeader(
            topics = listOf(BagTopic("Time", "s", listOf("xaxis")), BagTopic("Log, all")),
            values = listOf(BagValue(Value("Match", "8"))),
        )
        RowWriter().header(header).number(0.02).text("armed, ready").endRow().number(-3.0).empty().endRow()
            .written() shouldBe
            "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]}," +
            "{\"name\":\"Log, all\",\"unit\":\"ul\",\"attrs\":[]}],\"values\":[{\"name\":\"Match\",\"value\":\"8\"}]}\n" +
            "Time,\"Log, all\"\n0.020000,\"armed, ready\"\n-3.0000,\n"
    }

    test("a newline in a topic's name becomes a space, in both header lines") {
        val header = BagHeader(listOf(BagTopic("a\nb"), BagTopic("c")))
        val recording = parse(RowWriter().header(header).number(1.0).number(2.0).endRow().written())
        recording.topics.map { it.name } shouldBe listOf("a b", "c")
    }

    test("both header lines have the same name for any topic") {
        for (name in listOf("a\r\nb", "\u0000", "a\u0000b", "\uD83E", "a\uDD16b", "\uD83E\uDD16")) {
            val header = BagHeader(listOf(BagTopic(name, "s"), BagTopic("c", "V")))
            for (asOriginal in listOf(false, true)) {
                val recording = parse(RowWriter().header(header, asOriginal).number(1.0).number(2.0).endRow().written())
                recording.topics.map { it.unit } shouldBe listOf("s", "V")
                recording.problems.filter { it.kind != ProblemKind.UNUSUAL_NAME }.shouldBeEmpty()
            }
        }
    }

    test("a cleared writer starts over") {
        val writer = RowWriter().number(1.0)
        writer.clear()
        writer.number(2.0).endRow().written() shouldBe "2.0000\n"
    }

    test("a dropped row leaves the rows before it") {
        val writer = RowWriter().number(1.0).endRow().number(2.0).number(3.0)
        writer.dropRow()
        writer.number(4.0).endRow().written() shouldBe "1.0000\n4.0000\n"
    }

    test("a row of one empty cell is not a blank line") {
        val recording = parse(RowWriter().text("a").endRow().empty().endRow().number(1.0).endRow().written())
        recording.rowCount shouldBe 2
    }

    test("times keep their microseconds") {
        RowWriter().microseconds(100.02).microseconds(0.1 + 0.2).microseconds(-0.0000001).microseconds(-2.5)
            .microseconds(0.9999999).microseconds(-0.0).microseconds(1.7720000001235e9).microseconds(1.772e15)
            .microseconds(-1.0e19).microseconds(Double.NaN).endRow()
            .written() shouldBe "100.020000,0.300000,0.000000,-2.500000,1.000000,0.000000,1772000000.123500," +
            "1772000000000000.000000,-1.0000e+19,NaN\n"
    }

    test("exact numbers are written as a person would write them") {
        val numbers = listOf(
            0.0 to "0", -0.0 to "-0", 1.0 to "1", -7.0 to "-7", 0.02 to "0.02", 100.02 to "100.02", 12.346 to "12.346",
            1e5 to "100000", 1.0e15 to "1000000000000000", 9007199254740991.0 to "9007199254740991", 1e22 to "1e22",
            1.2346e30 to "1.2346e30", 1e-4 to "0.0001", 1.2346e-5 to "1.2346e-5", 1e-7 to "1e-7", -1.5e-300 to "-1.5e-300",
            0.1 + 0.2 to "0.30000000000000004", 12345678.123456789 to "12345678.12345679", 1.0 / 3 to "0.3333333333333333",
            1.7976931348623157e308 to "1.7976931348623157e308", 123456789012.34567 to "123456789012.34567",
            Double.NaN to "NaN", Double.POSITIVE_INFINITY to "Infinity", Double.NEGATIVE_INFINITY to "-Infinity",
        )
        for ((number, text) in numbers) RowWriter().exact(number).endRow().written() shouldBe "$text\n"
    }

    test("any exact number is read back to the last bit") {
        val shapes = listOf(
            Arb.long().map { Double.fromBits(it) },
            Arb.double(-1e6, 1e6),
            Arb.int().map { it / 1e6 },
            Arb.long().map { it.toDouble() },
        )
        for (shape in shapes) {
            checkAll(shape) { number ->
                val recording = parse(RowWriter().text("a").text("b").endRow().exact(number).integer(1).endRow().written())
                val read = recording.topics[0].samples.firstOrNull() ?: Double.NaN
                read.toBits() shouldBe number.toBits()
            }
        }
    }

    test("whitespace of any kind at a title's ends is part of the title") {
        for (name in listOf(" a", "a ", "\ta", "a\u00A0")) {
            parse(RowWriter().header(BagHeader(listOf(BagTopic(name), BagTopic("b")))).written()).topics[0].name shouldBe name
        }
    }

    test("whole numbers keep all their digits, and truth values are words") {
        RowWriter().integer(0).integer(-7).integer(1234567890123).integer(Long.MAX_VALUE).integer(Long.MIN_VALUE)
            .truth(true).truth(false).endRow()
            .written() shouldBe "0,-7,1234567890123,9223372036854775807,-9223372036854775808,true,false\n"
    }

    test("any text survives writing and reading") {
        checkAll(Arb.string(0..40)) { text ->
            val recording = parse(RowWriter().text("n").text("text").endRow().number(1.0).text(text).endRow().written())
            recording.rowCount shouldBe 1
            val topic = recording.topics[1]
            // A text that looks like a number, or like nothing, is read as such; a lone surrogate is not text.
            if (topic.texts.size == 1 && text.none { it.isSurrogate() }) {
                topic.texts[0] shouldBe text.replace('\u0000', '\uFFFD')
            }
        }
    }

    test("any numbers survive with five digits") {
        checkAll(Arb.list(Arb.double(), 1..20)) { numbers ->
            val writer = RowWriter()
            numbers.forEachIndexed { index, _ -> writer.text("c$index") }
            writer.endRow()
            for (number in numbers) writer.number(number)
            writer.endRow()
            val recording = parse(writer.written())
            recording.topics.forEachIndexed { index, topic ->
                val buffer = ByteArray(FiveDigitFormat.MAX_LENGTH)
                val text = buffer.decodeToString(0, FiveDigitFormat.write(numbers[index], buffer, 0))
                // As text, because NaN does not equal NaN.
                topic.samples.joinToString() shouldBe doubleArrayOf(text.toDouble()).joinToString()
            }
        }
    }
})
