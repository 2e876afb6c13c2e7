package badlog.core.bag

import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TopicKind
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith

class BagParserSpec : FunSpec({
    test("a bag's values, topics, numbers, texts and states are read unchanged") {
        val recording = parse(VARIED_BAG)
        recording.format shouldBe RecordingFormat.BAG
        recording.rowCount shouldBe 6
        recording.values shouldBe listOf(Value("Match", "8"))
        val (time, angle, log, enabled) = recording.topics
        time.samples.toList() shouldBe listOf(0.0, 0.02, 0.04, 0.06, 0.08, 0.1)
        time.attributes shouldBe listOf("xaxis", "hide")
        angle.unit shouldBe "deg"
        angle.samples[1] shouldBe -123460.0
        angle.samples[2].shouldBeNaN()
        angle.samples[3] shouldBe 1e-5
        List(log.texts.size) { log.texts.rows[it] to log.texts[it] } shouldBe
            listOf(1 to "armed, ready", 2 to "said \"go\"\ntwice", 4 to "Ω ready")
        log.kind shouldBe TopicKind.STATE
        enabled.kind shouldBe TopicKind.BOOLEAN
        enabled.samples.toList() shouldBe listOf(0.0, 0.0, 1.0, 1.0, 1.0, 1.0)
        recording.isSalvaged shouldBe false
    }

    test("the size of the pieces in which a file arrives makes no difference") {
        val whole = describe(parse(VARIED_BAG))
        for (piece in listOf(1, 2, 3, 5, 7, 64, 1000)) describe(parse(VARIED_BAG, piece)) shouldBe whole
    }

    test("counting without keeping samples finds the same topics, counts and problems") {
        val bytes = VARIED_BAG.encodeToByteArray() + "0.2,1,".encodeToByteArray() + byteArrayOf(-28, 10) + "0.4\n".encodeToByteArray()
        val kept = parse(bytes)
        val counted = BagParser(keepSamples = false).run {
            accept(bytes)
            finish()
        }
        kept.problems.map { it.kind } shouldContain ProblemKind.NOT_UTF8
        counted.topics.map { it.name to it.counts } shouldBe kept.topics.map { it.name to it.counts }
        counted.problems shouldBe kept.problems
    }

    test("an expected size that is wrong only costs memory") {
        for (expected in listOf(1L, 100L, 10_000_000L)) {
            val parser = BagParser(expectedBytes = expected)
            val rows = (0 until 500).joinToString("") { "$it,${it * 2}\n" }
            parser.accept("a,b\n$rows".encodeToByteArray())
            parser.finish().topics[1].samples.toList() shouldBe List(500) { it * 2.0 }
        }
    }

    test("an expected number of lines that is wrong only costs memory") {
        val bytes = ("a,b\n" + (0 until 500).joinToString("") { "$it,${it * 2}\n" }).encodeToByteArray()
        for (lines in listOf(1L, 100L, 501L, 502L, 900L, 10_000_000L)) {
            val parser = BagParser(bytes.size.toLong(), keepSamples = true, NumberSinks.RECORDING, expectedLines = lines)
            parser.accept(bytes)
            parser.finish().topics[1].samples.toList() shouldBe List(500) { it * 2.0 }
        }
    }

    test("neither short first rows nor a wrong expected size allocate room for far more rows than have arrived") {
        val columns = 2000
        val text = List(columns) { "c$it" }.joinToString(",") + "\n" + ("0,".repeat(columns - 1) + "0\n").repeat(100)
        // Room for all the rows that this size promises would be a terabyte.
        val parser = BagParser(expectedBytes = 1L shl 40)
        parser.accept(text.encodeToByteArray())
        parser.finish().rowCount shouldBe 100
    }

    test("repeated texts are kept once") {
        val recording = parse("t,state\n" + (0 until 1000).joinToString("") { "$it,state ${it % 3}\n" })
        recording.topics[1].texts.dictionary shouldBe listOf("state 0", "state 1", "state 2")
        recording.topics[1].texts[4] shouldBe "state 1"
    }

    test("a problem that occurs a thousand times is listed ten times and counted") {
        val recording = parse("a,b\n" + "1\n".repeat(1000))
        val short = recording.problems.filter { it.kind == ProblemKind.ROW_SHORT }
        short.size shouldBe 11
        short.sumOf { it.count } shouldBe 1000
        short.first().line shouldBe 2
        recording.rowCount shouldBe 1000
    }

    test("a stray quote never swallows a complete row after it") {
        val recording = parse("a,b\n1,\"oops\n2,x\n3,y\n4,\"z\"\n")
        recording.rowCount shouldBe 4
        recording.topics[0].samples.toList() shouldBe listOf(1.0, 2.0, 3.0, 4.0)
        recording.topics[1].texts[3] shouldBe "z"
    }

    test("a problem names the physical line, even after a text with newlines") {
        val recording = parse("a,b\n1,\"x\ny\nz\"\n2\n")
        recording.problems.single { it.kind == ProblemKind.ROW_SHORT }.line shouldBe 5
    }

    test("compressed bytes and a WPILOG are reported with their format") {
        parse(byteArrayOf(0x1f, 0x8b.toByte(), 8, 0, 0, 0, 0)).isReadable shouldBe false
        parse("WPILOG\u0000\u0001\u0000\u0000\u0000\u0000").problems.first().kind shouldBe ProblemKind.NOT_A_RECORDING
    }

    test("spreadsheet files are reported, with advice") {
        parse("a;b\nx;y\n").problems.last().message shouldContain "semicolons"
        parse("a\tb\nx\ty\n").problems.last().message shouldContain "tabs"
        parse(byteArrayOf(-1, -2) + "a,b\n1,2\n".encodeToByteArray().flatMap { listOf(it, 0) })
            .problems.last().message shouldContain "UTF-16"
        parse(byteArrayOf(-1, -2) + "abcdef".encodeToByteArray()).problems.last().message shouldContain "UTF-16"
    }

    test("a control character in a value does not lose the file") {
        val recording = parse("{\"values\":[{\"name\":\"v\",\"value\":\"\u001b[1m\"}]}\na,b\n1,2\n")
        recording.values.single().text shouldBe "\u001b[1m"
        recording.rowCount shouldBe 1
    }

    test("40,000 equal names are distinguished in a time that grows only with their number") {
        parse(List(40_000) { "a" }.joinToString(",") + "\n").topics.last().name shouldBe "a (40000)"
    }

    test("rows beyond the limit are not read, which is reported") {
        val parser = BagParser().apply { maxRows = 3 }
        parser.accept("a,b\n1,2\n3,4\n5,6\n7,8\n9,10\n".encodeToByteArray())
        val recording = parser.finish()
        recording.rowCount shouldBe 3
        recording.problems.single().kind shouldBe ProblemKind.TOO_MANY_ROWS
        recording.problems.single().message shouldEndWith "; the rest was not read."
        BagParser().apply { maxRows = 3 }.run {
            accept("a,b\n1,2\n3,4\n5,6\n".encodeToByteArray())
            finish().problems.shouldBeEmpty()
        }
    }

    test("blank lines are counted by the million, the first ones with their places") {
        for ((newline, before) in listOf("\n" to "", "\r\n" to "a,b\n1,2\n")) {
            val parser = BagParser()
            parser.accept(before.encodeToByteArray())
            repeat(20) { parser.accept(newline.repeat(100_000).encodeToByteArray()) }
            val blank = parser.finish().problems.filter { it.kind == ProblemKind.BLANK_LINE }
            blank.sumOf { it.count } shouldBe 2_000_000
            blank.take(3).map { it.line } shouldBe List(3) { it + 1 + before.count { char -> char == '\n' } }
        }
    }

    test("a line of millions of commas is refused before it has cost a column each") {
        parse(",".repeat(5_000_000) + "\n1\n").problems.single().kind shouldBe ProblemKind.NOT_A_RECORDING
    }

    test("a row of ordinary numbers reports nothing") {
        parse("{\"topics\":[{\"name\":\"a\"}],\"values\":[]}\na\n1.0000\n").problems.shouldBeEmpty()
    }

    test("a header alone opens with its topics, and the lack of rows is reported") {
        val recording = parse("{\"topics\":[{\"name\":\"a\",\"unit\":\"V\"}],\"values\":[]}\n")
        recording.topics.single().unit shouldBe "V"
        recording.problems.map { it.kind } shouldContain ProblemKind.NO_ROWS
    }
})
