package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

/** Returns a bag with the x axis `Time` of [unit], and each of [rows] below the titles. */
private fun bag(unit: String, rows: List<String>, values: String = "", attributes: String = "\"xaxis\"") = """{"topics":[{"name":"State","unit":"ul","attrs":[]},{"name":"Time","unit":"$unit","attrs":[$attributes]}],"values":[$values]}""" +
    "\nState,Time\n" + rows.joinToString("") { "$it\n" }

private fun Recording.times() = topics.first { it.name == "Time" }.samples.toList()

class BagClockSpec : FunSpec({
    test("an x axis of times since 1970 begins at 0, in any unit, and says when that was") {
        for ((unit, digits) in listOf("s" to "", "ul" to "", "ms" to "000", "us" to "000000", "ns" to "000000000")) {
            val recording = parse(bag(unit, List(30) { "up,${1_795_832_420 + it}$digits" }))
            recording.times() shouldBe List(30) { it.toDouble() }
            recording.topics.map { it.unit } shouldBe listOf("ul", "s")
            recording.values shouldBe listOf(Value("Start Time", "2026-11-28 02:20:20 UTC"))
            recording.problems.map { it.kind to it.topic } shouldBe listOf(ProblemKind.CSV_DIALECT to "Time")
        }
    }

    test("a bag that says itself when it starts keeps that") {
        val own = """{"name":"Start Time","value":"2026-11-28T03:20:19"}"""
        val recording = parse(bag("s", listOf("up,1795832420.5", "up,1795832420.52"), own))
        recording.times() shouldBe listOf(0.0, 0.02)
        recording.values shouldBe listOf(Value("Start Time", "2026-11-28T03:20:19"))
    }

    test("other large numbers stay") {
        // A robot that counts µs since its start has such numbers after 17 minutes.
        for (text in listOf(bag("us", listOf("up,1795832420", "up,1795852420")), bag("s", listOf("up,1795832420", "up,1795832421"), attributes = ""))) {
            val recording = parse(text)
            recording.times()[0] shouldBe 1795832420.0
            recording.values.shouldBeEmpty()
            recording.problems.shouldBeEmpty()
        }
    }

    test("rows without a time, before the first one, do not matter") {
        val recording = parse(bag("s", listOf("\"a, b\",", "up", "up,1795832420", "up,1795832421")))
        recording.times().takeLast(2) shouldBe listOf(0.0, 1.0)
        recording.problems.map { it.kind } shouldContain ProblemKind.ROW_SHORT
    }

    test("everything but the times is read as in a bag that begins at 0, in pieces of any size") {
        val states = Arb.element("up", "", "\"a, b\"", "\"say \"\"up\"\"\"", "\"two\nlines\"", "1.5", "say \"up\"", "true", "ü", "\u0000")
        checkAll(Arb.list(states, 1..30), Arb.int(1..400)) { cells, piece ->
            fun read(start: Long, size: Int) = parse(bag("s", listOf("up,$start") + cells.mapIndexed { i, cell -> "$cell,${start + i}" }), size)
            val small = read(0, 1 shl 20)
            val large = read(1_795_832_420, piece)
            large.times() shouldBe small.times()
            large.rowCount shouldBe small.rowCount
            large.topics[0].texts.dictionary shouldBe small.topics[0].texts.dictionary
            large.topics.map { it.counts } shouldBe small.topics.map { it.counts }
            large.problems.filter { it.kind != ProblemKind.CSV_DIALECT }.map { it.kind to it.line } shouldBe small.problems.map { it.kind to it.line }
        }
    }

    test("rows that are read in batches, or without their samples, count from the first one, too") {
        val head = bag("s", listOf("up,1795832420.5"))
        for (keepsSamples in listOf(true, false)) {
            for (first in listOf(head, bag("s", emptyList()))) {
                val parser = BagParser(keepSamples = keepsSamples).also { it.accept(first.encodeToByteArray()) }
                val rows = "up,1795832421.5\nup,1795832422.5\n".encodeToByteArray()
                val readsComma = if (first == head) checkNotNull(parser.readsDecimalComma) else booleanArrayOf(true, true)
                val batch = checkNotNull(RowBatchParser(readsComma, keepsSamples).parse(rows, 0, rows.size))
                if (!parser.accept(batch)) parser.accept(rows)
                val recording = parser.finish()
                recording.values.single().text shouldBe if (first == head) "2026-11-28 02:20:20 UTC" else "2026-11-28 02:20:21 UTC"
                recording.topics.map { it.unit } shouldBe listOf("ul", "s")
                if (keepsSamples) recording.times().takeLast(2) shouldBe if (first == head) listOf(1.0, 2.0) else listOf(0.0, 1.0)
            }
        }
    }

    test("written as a bag and read again, it is the same") {
        val recording = parse(bag("ms", listOf("up,1795832420500", "\"a, b\",1795832420520")))
        val out = StringBuilder()
        RecordingWriter(recording).write { bytes, size -> out.append(bytes.decodeToString(0, size)) }
        val again = parse(out.toString())
        again.times() shouldBe listOf(0.0, 0.02)
        again.values shouldBe recording.values
        again.topics.map { it.unit } shouldBe listOf("ul", "s")
        again.problems.shouldBeEmpty()
    }
})
