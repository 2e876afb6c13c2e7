package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.text.NUL
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import kotlin.random.Random

class BagFuzzingSpec : FunSpec({
    test("random bytes never make the parser throw, whole or in pieces, and read the same either way") {
        checkAll(Arb.byteArray(Arb.int(0..300), Arb.byte())) { bytes ->
            describe(parse(bytes, 7)) shouldBe describe(parse(bytes))
        }
    }

    test("random fragments after a good header never make the parser throw, and pieces make no difference") {
        val header = "{\"topics\":[{\"name\":\"a\"},{\"name\":\"b\"},{\"name\":\"c\",\"attrs\":[\"log\"]}]}\na,b,c\n"
        checkAll(Arb.list(Arb.element(FRAGMENTS), 0..60).map { it.joinToString("") }) { body ->
            val whole = describe(parse(header + body))
            describe(parse(header + body, 1)) shouldBe whole
            describe(parse(header + body, 3)) shouldBe whole
        }
    }

    test("random fragments of JSON as the first line never make the parser throw") {
        val pieces = listOf("{", "}", "[", "]", "\"topics\"", "\"name\"", ":", ",", "\"a\"", "1", "0x", "\\u00e", "null", "\u0007")
        checkAll(Arb.list(Arb.element(pieces), 0..40).map { it.joinToString("") }) { line ->
            describe(parse("{$line\na,b\n1,2\n", 5)) shouldBe describe(parse("{$line\na,b\n1,2\n"))
        }
        parse("{\"a\":" + "[".repeat(100_000) + "\na,b\n1,2\n").rowCount shouldBe 1
    }

    test("every cell of every row is accounted for, whatever the rows hold") {
        checkAll(Arb.list(Arb.element(FRAGMENTS), 0..60).map { it.joinToString("") }) { body ->
            val recording = parse("x,y\n$body")
            for (topic in recording.topics) topic.counts.total shouldBe recording.rowCount
        }
    }

    test("a file cut at any byte keeps every whole row before the cut") {
        val bytes = VARIED_BAG.encodeToByteArray()
        val rowEnds = VARIED_ROWS.indices.map { row ->
            (VARIED_HEADER + VARIED_ROWS.take(row + 1).joinToString("")).encodeToByteArray().size
        }
        for (cut in 0..bytes.size) {
            val whole = rowEnds.count { it <= cut }
            val recording = parse(bytes.copyOf(cut))
            val lastWithoutNewline = recording.problems.count { it.kind == ProblemKind.LAST_CELL_CUT }
            recording.rowCount - lastWithoutNewline shouldBe whole
        }
    }

    test("whole rows survive damage anywhere else") {
        val random = Random(1014)
        repeat(PropertyTesting.defaultIterationCount) {
            val lines = List(40) { row -> "$row,${row * 2},${row * 3}" }.toMutableList()
            val damaged = List(random.nextInt(1, 5)) { random.nextInt(lines.size) }.toSet()
            for (row in damaged) {
                lines[row] = List(random.nextInt(0, 8)) { FRAGMENTS.random(random) }.joinToString("")
                    .replace("\n", " ").replace("\r", " ")
            }
            val text = "x,y,z\n" + lines.joinToString("\n") + "\n"
            val found = parse(text, 13).topics[0].samples.toSet()
            // The row right after a NUL counts as the rest of a damaged row unless it is complete by itself.
            for (row in lines.indices) {
                if (row in damaged || (row - 1 in damaged && '\u0000' in lines[row - 1])) continue
                if (row.toDouble() !in found) throw AssertionError("row $row is lost in:\n$text")
            }
        }
    }
})
