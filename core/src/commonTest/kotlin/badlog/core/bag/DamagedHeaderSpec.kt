package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlin.random.Random

private val NAMES = List(30) { if (it == 0) "Time" else "Folder ${it % 4}/Topic $it" }

private fun json(names: List<String> = NAMES) = "{\"topics\":[" + names.joinToString(",") { "{\"name\":\"$it\",\"unit\":\"V\",\"attrs\":[]}" } + "],\"values\":[]}\n"

private val ROWS = (1..20).joinToString("") { row -> List(30) { "${row * 100 + it}" }.joinToString(",") + "\n" }

private fun Recording.doubts() = problems.filter { it.kind == ProblemKind.NAME_IN_DOUBT }.mapNotNull { it.topic }

private fun Recording.kinds() = problems.map { it.kind }

/** The cell of each topic in the first row. */
private fun Recording.firstRow() = topics.associate { it.name to it.samples[0].toInt() }

private val RIGHT = NAMES.withIndex().associate { (index, name) -> name to 100 + index }

class DamagedHeaderSpec : FunSpec({
    val titles = NAMES.joinToString(",")

    test("if a comma of the titles is lost, line 1 names the columns") {
        val recording = parse(json() + titles.replace(",Folder 3/Topic 11", "-Folder 3/Topic 11") + "\n" + ROWS)
        recording.firstRow() shouldBe RIGHT
        recording.kinds() shouldContainExactly listOf(ProblemKind.TITLES_DAMAGED)
        recording.isSalvaged shouldBe true
    }

    test("if a hole destroyed any part of the titles, line 1 names the columns") {
        val line = "$titles\n"
        for (from in listOf(0, 1, 60, line.length - 250, line.length - 251)) {
            val holed = line.take(from) + "\u0000".repeat(250) + line.drop(from + 250)
            val recording = parse(json() + holed + ROWS)
            val isNewlineLost = from + 250 >= line.length
            recording.firstRow() shouldBe RIGHT.mapValues { (_, value) -> if (isNewlineLost && recording.rowCount < 20) value + 100 else value }
            recording.doubts().shouldBeEmpty()
        }
    }

    test("if the titles gained a newline or a quote, line 1 names the columns and no row is lost") {
        for (odd in listOf("\n", "\"", "\"\n", ",", "\u0003\r\n")) {
            val recording = parse(json() + titles.replaceFirst("Topic 9,", odd + "Topic 9,") + "\n" + ROWS)
            recording.firstRow() shouldBe RIGHT
            recording.rowCount shouldBe 20
        }
    }

    test("a title that differs in a letter gets its name from line 1, marked as doubtful") {
        val recording = parse(json() + titles.replace("Topic 7,", "Tmpic 7,") + "\n" + ROWS)
        recording.firstRow() shouldBe RIGHT
        recording.doubts() shouldContainExactly listOf("Folder 3/Topic 7")
    }

    test("a title damaged into another topic's name does not take that topic's column") {
        val recording = parse(json() + titles.replace("Folder 3/Topic 7,", "Folder 0/Topic 8,") + "\n" + ROWS)
        recording.firstRow() shouldBe RIGHT
        recording.doubts() shouldContainExactly listOf("Folder 3/Topic 7")
    }

    test("if line 2 has its own order and lost a comma, every column's name is doubtful") {
        val reversed = NAMES.reversed().joinToString(",")
        val recording = parse(json() + reversed.replace(",Folder 3/Topic 11", "-Folder 3/Topic 11") + "\n" + ROWS)
        recording.doubts().toSet() shouldBe NAMES.toSet()
        recording.firstRow().getValue("Time") shouldBe 129
        recording.firstRow().getValue("Folder 1/Topic 29") shouldBe 100
    }

    test("losing the titles with their newline costs no row") {
        val recording = parse(json() + ROWS)
        recording.firstRow() shouldBe RIGHT
        recording.rowCount shouldBe 20
    }

    test("a damaged byte in the first two lines loses no rows") {
        for (damage in listOf("\u0000ab\u0003", "\u0003", "\u001b\u0001\u0002")) {
            for (at in listOf(0, 700, json().length + 1, json().length + 200)) {
                val text = json() + titles + "\n" + ROWS
                val recording = parse(text.take(at) + damage + text.drop(at + damage.length))
                recording.isReadable shouldBe true
                recording.rowCount shouldBe 20
                for ((name, value) in recording.firstRow()) if (name in RIGHT && name !in recording.doubts()) RIGHT[name] shouldBe value
            }
        }
    }

    test("a CSV file with a control character in a title opens, with that title doubtful") {
        val recording = parse("Time,Vo\u0003lts,Amps\n0,12,3\n1,11,4\n")
        recording.rowCount shouldBe 2
        recording.doubts() shouldContainExactly listOf("Vo lts")
    }

    test("if a CSV file's titles do not fit its rows, every name is doubtful and rows stay whole") {
        val recording = parse("Time-Volts,Mode\n" + (0 until 9).joinToString("") { "$it,12.$it,auto $it\n" })
        recording.rowCount shouldBe 9
        recording.topics.map { it.name } shouldContainExactly listOf("Time-Volts", "Mode", "Column 3")
        recording.doubts().size shouldBe 3
    }

    test("remarks before the titles of a CSV file are skipped") {
        val recording = parse("Robot,1014\nOhio\nTime,Volts,Mode\n" + (0 until 9).joinToString("") { "$it,12.$it,auto\n" })
        recording.topics.map { it.name } shouldContainExactly listOf("Time", "Volts", "Mode")
        recording.rowCount shouldBe 9
        recording.problems.single { it.kind == ProblemKind.HEADER_UNREADABLE }.line shouldBe 1
    }

    test("a bag with a damaged first byte has its titles on line 2") {
        val recording = parse("[" + json().drop(1) + titles + "\n" + ROWS)
        recording.firstRow() shouldBe RIGHT
        recording.kinds() shouldContain ProblemKind.HEADER_UNREADABLE
    }

    test("the rest of a line of JSON after a newline is not read as titles") {
        val names = NAMES.take(3)
        val line = json(names)
        val rows = (1..20).joinToString("") { row -> "${row}00,${row}01,${row}02\n" }
        for (at in 1 until line.length - 1) {
            val recording = parse(line.replaceRange(at, at + 1, "\n") + names.joinToString(",") + "\n" + rows)
            recording.topics.map { it.name } shouldContainExactly names
            recording.firstRow().values.toList() shouldBe listOf(100, 101, 102)
            recording.rowCount shouldBe 20
        }
    }

    test("a tab in the rest of a line of JSON loses no rows") {
        val text = json().take(300) + "\n\tab\t\n" + titles.replace("Topic 1,", "To\tpic 1,") + "\n" + ROWS.replaceFirst("101", "1\t1")
        parse(text).run {
            isReadable shouldBe true
            rowCount shouldBe 20
        }
    }

    test("if a CSV file's titles end in a hole, every name is doubtful") {
        val recording = parse("Time,Volts,Am" + "\u0000".repeat(60) + ",7\n" + (0 until 9).joinToString("") { "$it,12.$it,$it\n" })
        recording.rowCount shouldBe 9
        recording.doubts() shouldContainExactly listOf("Time", "Volts", "Am")
    }

    test("bytes without rows of text are not a log") {
        for (bytes in listOf("\u0001\u0002\u0003\n\u0004\n", "PK\u0003\u0004,\u0007\nab,\u0001,\n", "\u007fELF\u0002\n\u0001,2\n")) {
            parse(bytes).kinds() shouldContainExactly listOf(ProblemKind.NOT_A_RECORDING)
        }
    }

    test("a picture is not a log, even if some of its bytes look like rows") {
        for (seed in 0 until 300) {
            val bytes = "\u0000PNG\r\n\u001a\n".encodeToByteArray() + Random(seed).nextBytes(20_000)
            bytes[0] = 0x89.toByte()
            parse(bytes).kinds() shouldContain ProblemKind.NOT_A_RECORDING
        }
    }
})
