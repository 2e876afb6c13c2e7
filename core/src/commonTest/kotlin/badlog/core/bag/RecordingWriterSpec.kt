package badlog.core.bag

import badlog.core.conformance.corpusFileNames
import badlog.core.conformance.readCorpusFile
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

class RecordingWriterSpec : FunSpec({
    /** Returns whether [text] may be read back as rows, which no file can prevent. */
    fun mayLookLikeRows(text: String) = text.any { it in "\r\n" } && text.any { it in ",\"" }

    fun shouldComeBack(recording: Recording) {
        val bag = write(recording)
        describeContent(parse(bag)) shouldBe describeContent(recording)
        val csv = parse(write(recording, RecordingFormat.CSV))
        // Without attributes, a text with a comma may be a number with a decimal comma.
        if (recording.topics.size > 1 && recording.topics.none { "log" in it.attributes }) {
            csv.topics.map { describeCells(csv, it.name) } shouldBe
                recording.topics.map { describeCells(recording, it.name) }
        }
    }

    test("a bag is readable text") {
        write(parse(VARIED_BAG)) shouldBe VARIED_HEADER + """
            0,12.346,,false
            0.02,-123460,"armed, ready",false
            0.04,,"said ""go""
            twice",true
            0.06,1e-5,,true
            0.08,,Ω ready,true
            0.1,99,,true

        """.trimIndent()
    }

    test("a CSV file has the titles first") {
        write(parse("Time,State\n0.5,on\n1,off\n"), RecordingFormat.CSV) shouldBe "Time,State\n0.5,on\n1,off\n"
    }

    for (name in corpusFileNames().filter { it.endsWith(".bag") }) {
        test("${name.removeSuffix(".bag")} comes back as it was") {
            shouldComeBack(parse(readCorpusFile(name)))
        }
    }

    test("everything salvaged from damaged files survives writing and reading") {
        val header = "{\"topics\":[{\"name\":\"a\"},{\"name\":\"b\"},{\"name\":\"c\",\"attrs\":[\"log\"]}]}\na,b,c\n"
        checkAll(Arb.list(Arb.element(FRAGMENTS), 0..60).map { it.joinToString("") }) { body ->
            for (recording in listOf(parse(header + body), parse("x,y\n$body"))) {
                if (recording.topics.none { it.texts.dictionary.any(::mayLookLikeRows) }) shouldComeBack(recording)
            }
        }
    }

    test("a recording's numbers survive writing and reading to the last bit") {
        val anyBits = Arb.long().map { Double.fromBits(it) }
        checkAll(Arb.list(anyBits, 1..20), Arb.list(Arb.double(-1e4, 1e4), 20..20)) { bits, others ->
            val writer = RowWriter().text("bits").text("other").endRow()
            for (i in bits.indices) writer.exact(bits[i]).exact(others[i]).endRow()
            val recording = parse(writer.bytes.copyOf(writer.size))
            // As text, because NaN does not equal NaN.
            recording.topics[1].samples.joinToString() shouldBe others.take(bits.size).joinToString()
            shouldComeBack(recording)
        }
    }

    test("line 1 is kept unchanged if it still describes the recording") {
        val line = "{ \"values\":[],\"by\":\"us\", \"topics\":[{\"name\":\"a\",\"color\":\"red\"},{\"name\":\"b\"}]}"
        write(parse("$line\na,b\n1,2\n")) shouldBe "$line\na,b\n1,2\n"
        // The line would describe a topic without a column.
        write(parse("$line\na\n1\n")) shouldBe "{\"topics\":[{\"name\":\"a\",\"unit\":\"ul\",\"attrs\":[]," +
            "\"color\":\"red\"}],\"values\":[],\"by\":\"us\"}\na\n1\n"
    }

    test("rows can be selected, with their texts") {
        val recording = parse(VARIED_BAG)
        checkAll(50, Arb.int(0..6), Arb.int(0..6)) { one, other ->
            val rows = minOf(one, other) until maxOf(one, other)
            val picked = parse(write(recording, rows = rows))
            picked.rowCount shouldBe rows.count()
            picked.topics[0].samples.toList() shouldBe recording.topics[0].samples.slice(rows)
            List(picked.topics[2].texts.size) { picked.topics[2].texts[it] } shouldBe
                recording.topics[2].texts.run { rows.filter { it in this.rows }.map { this[this.rows.indexOf(it)] } }
        }
    }

    test("difficult names survive in both formats") {
        for (name in listOf("a,b", "\"a\"", " a ", "\ta", "\u00A0a", "{a", "WPILOG", "\uFEFFa", "Ω\uD83E\uDD16", "1")) {
            val header = BagHeader(listOf(BagTopic(name), BagTopic("x")))
            val recording = parse(RowWriter().header(header).exact(1.0).exact(2.0).endRow().run { bytes.copyOf(size) })
            recording.topics[0].name shouldBe name
            shouldComeBack(recording)
        }
    }

    test("a name that no title can hold comes back as a similar one") {
        for (escape in listOf("\\n", "\\u0000", "\\uD800")) {
            // Without a line of titles, the names are those of line 1.
            val recording = parse("{\"topics\":[{\"name\":\"a${escape}b\",\"unit\":\"m\"},{\"name\":\"c\"}]}")
            val again = parse(write(recording))
            again.topics.map { it.unit } shouldBe listOf("m", "ul")
            again.topics[0].name.length shouldBe 3
        }
    }

    test("a single column with an odd title is still read as the same table") {
        for (name in listOf("a;b", "a\tb", "a\u0007b")) {
            val header = BagHeader(listOf(BagTopic(name)))
            val bag = parse(RowWriter().header(header).exact(1.0).endRow().run { bytes.copyOf(size) })
            val csv = parse(write(bag, RecordingFormat.CSV))
            csv.topics.map { it.name } shouldBe listOf("a b")
        }
    }

    test("NaN stays NaN if no cell was empty, or if the topic's kind depends on it") {
        write(parse("a,b\n1,NaN\n2,3\n"), RecordingFormat.CSV) shouldBe "a,b\n1,NaN\n2,3\n"
        write(parse("a,b\n1,NaN\n2,\n3,4\n"), RecordingFormat.CSV) shouldBe "a,b\n1,\n2,\n3,4\n"
        write(parse("a,b\n1,NaN\n2,\n3,true\n"), RecordingFormat.CSV) shouldBe "a,b\n1,NaN\n2,NaN\n3,1\n"
    }

    test("progress is reported in rows, up to the last") {
        val recording = parse("a,b\n" + "1,2\n".repeat(50_000))
        val reported = ArrayList<Int>()
        var size = 0
        val progress = { done: Int, total: Int ->
            total shouldBe 40_000
            reported += done
        }
        RecordingWriter(recording).write(0, 40_000, progress) { _, count -> size += count }
        reported.last() shouldBe 40_000
        reported shouldBe reported.sorted()
        size shouldBe "a,b\n".length + 4 * 40_000
    }

    test("missing rows, and samples that were not kept, are errors") {
        val recording = parse(VARIED_BAG)
        for ((from, until) in listOf(-1 to 2, 3 to 2, 0 to 7)) {
            shouldThrow<IllegalArgumentException> { RecordingWriter(recording).write(from, until) { _, _ -> } }
        }
        val counted = BagParser(keepSamples = false).apply { accept(VARIED_BAG.encodeToByteArray()) }.finish()
        shouldThrow<IllegalArgumentException> { RecordingWriter(counted).write { _, _ -> } }
            .message shouldBe "The samples of “Time” were not kept."
    }
})
