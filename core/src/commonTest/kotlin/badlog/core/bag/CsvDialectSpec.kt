package badlog.core.bag

import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Severity
import badlog.core.recording.Topic
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll

private fun Recording.topic(name: String): Topic = topics.first { it.name == name }

private fun Recording.hints() = problems.filter { it.kind == ProblemKind.CSV_DIALECT }.map { it.message }

/** Thousandths as a person writes them. */
private fun written(thousandths: Long, point: Char, between: String): String {
    val whole = (thousandths / 1000).toString()
    val grouped = whole.reversed().chunked(3).joinToString(between.reversed()).reversed()
    return "$grouped$point${(thousandths % 1000).toString().padStart(3, '0')}"
}

class CsvDialectSpec : FunSpec({
    test("numbers with decimal commas are read with any column separator") {
        for (separator in listOf(';', '\t')) {
            val rows = (0 until 10).joinToString("") { "0,0$it${separator}1$it,5$separator-1,2${it}\n" }
            val recording = parse("Zeit${separator}Spannung${separator}Strom\n$rows")
            recording.topics.map { it.name } shouldBe listOf("Zeit", "Spannung", "Strom")
            recording.topic("Spannung").samples.toList() shouldBe List(10) { 10.5 + it }
            recording.topic("Strom").samples[3] shouldBe -1.23
            recording.problems.map { it.severity }.toSet() shouldBe setOf(Severity.NOTE)
            recording.hints().single() shouldContain "decimal commas"
        }
    }

    test("numbers of any width are read correctly in every dialect") {
        val dialects = Arb.element(listOf(Triple(';', ',', "."), Triple('\t', ',', ""), Triple(';', '.', ","), Triple(';', ',', " "), Triple('\t', '.', "'")))
        checkAll(dialects, Arb.int(2..6), Arb.int(2..40), Arb.long(0L..99_999_999L), Arb.boolean()) { (separator, point, between), columns, rows, seed, isQuoted ->
            fun value(row: Int, column: Int) = (seed * (row + 1) * (column + 3)) % 99_999_991L
            fun cell(row: Int, column: Int) = written(value(row, column), point, between).let { if (isQuoted) "\"$it\"" else it }
            // The first row leaves no doubt about the marks.
            val sure = List(columns) { written(1_234_567_891L, point, between) }.joinToString("$separator")
            val text = List(columns) { "c$it" }.joinToString("$separator") + "\n$sure\n" +
                (0 until rows).joinToString("") { row -> List(columns) { cell(row, it) }.joinToString("$separator") + "\n" }
            val recording = parse(text)
            for (column in 0 until columns) {
                recording.topics[column].samples.drop(1) shouldBe List(rows) { "${value(it, column) / 1000}.${(value(it, column) % 1000).toString().padStart(3, '0')}".toDouble() }
            }
            describe(parse(text, 7)) shouldBe describe(recording)
        }
    }

    test("a column alone may have decimal commas") {
        parse("Spannung\n" + (0 until 9).joinToString("") { "12,$it\n" }).topics.single().samples[4] shouldBe 12.4
    }

    test("Excel's line that names the separator is not the line of titles") {
        val recording = parse("sep=;\r\na;b\r\n1,5;2\r\n2,5;3\r\n")
        recording.topics.map { it.name } shouldBe listOf("a", "b")
        recording.topic("a").samples.toList() shouldBe listOf(1.5, 2.5)
        parse("sep=,\na,b\n1.5,2\n2.5,3\n").topic("a").samples.toList() shouldBe listOf(1.5, 2.5)
        parse("sep=\t\na\tb\n1.5\t2\n2.5\t3\n").topic("a").samples.toList() shouldBe listOf(1.5, 2.5)
        parse("sep=|\na|b\n1.5|2\n2.5|3\n").hints().single() shouldContain "by “|”"
    }

    test("commas between thousands, in quotes, are not decimal ones") {
        val recording = parse("t,speed\n0.02,\"1,234\"\n0.04,\"12,345\"\n0.06,\"1,234,567\"\n0.08,999\n")
        recording.topic("speed").samples.toList() shouldBe listOf(1234.0, 12345.0, 1_234_567.0, 999.0)
        recording.hints().single() shouldContain "commas between thousands"
    }

    test("a cell that does not fit the file's number notation stays a text, and is reported") {
        val recording = parse("t;v\n" + (0 until 500).joinToString("") { "0,$it;${if (it == 450) "1.2.3" else "$it,5"}\n" })
        recording.topic("v").texts.dictionary shouldBe listOf("1.2.3")
        recording.problems.map { it.kind } shouldContain ProblemKind.TEXT_IN_NUMBERS
    }

    test("texts between semicolons keep their commas and quotes") {
        val recording = parse("t;state;v\n0,1;up, slow;1,5\n0,2;\"down; \"\"fast\"\"\";2,5\n0,3;a \"b\", c;3,5\n")
        recording.topic("state").texts.dictionary shouldBe listOf("up, slow", "down; \"fast\"", "a \"b\", c")
        recording.topic("v").samples.toList() shouldBe listOf(1.5, 2.5, 3.5)
    }

    test("a row of units below the titles is not a row of values") {
        val recording = parse("Time,Voltage,State\n[s],[V],\n0.02,12.5,up\n0.04,12.4,down\n0.06,12.3,up\n")
        recording.topics.map { it.unit } shouldBe listOf("s", "V", "ul")
        recording.topic("Voltage").samples.toList() shouldBe listOf(12.5, 12.4, 12.3)
        recording.hints().single() shouldContain "units"
        parse("Zeit;U\ns;V\n0,1;12,5\n0,2;12,4\n").topics.map { it.unit } shouldBe listOf("s", "V")
    }

    test("below a row of units, thousands and times of day are still found") {
        val thousands = parse("Zeit;Drehzahl\ns;rpm\n0,1;1.234,5\n0,2;12.345,5\n0,3;987,5\n")
        thousands.topic("Drehzahl").samples.toList() shouldBe listOf(1234.5, 12_345.5, 987.5)
        thousands.topics.map { it.unit } shouldBe listOf("s", "rpm")
        val times = parse("timestamp,A\n,V\n" + (0 until 9).joinToString("") { "2024-03-16T10:11:32.${it}00,1$it\n" })
        times.topic("timestamp").samples.toList() shouldBe List(9) { it / 10.0 }
        times.topic("A").unit shouldBe "V"
    }

    test("a first row of texts above texts, or with a number, is not titles") {
        parse("t,state\n0.0,init\n0.1,run\n0.2,run\n").rowCount shouldBe 3
        parse("mode,state\noff,init\non,run\non,run\n").rowCount shouldBe 3
    }

    test("times in ISO 8601 become seconds, with the wall clock as a value, and x") {
        for (zone in listOf("", "Z", "+01:00")) {
            val rows = (0 until 20).joinToString("") { "2024-03-16T10:59:${(58 + it / 5).let { s -> if (s < 60) "$s" else "59" }}.${it % 5 * 2}00$zone,$it\n" }
            val recording = parse("timestamp,A\n$rows")
            val time = recording.topic("timestamp")
            time.samples[1] shouldBe 0.2
            time.samples[6] shouldBe 1.2
            time.unit shouldBe "s"
            time.attributes shouldBe listOf("xaxis")
            recording.values shouldBe listOf(Value("Start Time", "2024-03-16T10:59:58.000$zone"))
        }
    }

    test("times since 1970 begin at zero, in any unit") {
        for ((unit, digits) in listOf(1.0 to 0, 1e3 to 3, 1e6 to 6)) {
            val rows = (0 until 30).joinToString("") { "${1_795_832_420 + it}${"0".repeat(digits)},$it\n" }
            val time = parse("Timestamp,A\n$rows").topic("Timestamp")
            for (i in 0 until 30) time.samples[i] shouldBe (i.toDouble() plusOrMinus 1e-6 * unit.coerceAtMost(1.0))
        }
        parse("Timestamp,A\n1795832420.5,1\n1795832420.52,2\n").values shouldBe listOf(Value("Start Time", "2026-11-28 02:20:20 UTC"))
        parse("Encoder,A\n1795832420,1\n1795832421,2\n").topic("Encoder").samples[0] shouldBe 1795832420.0
    }

    test("whole numbers that no double holds are reported") {
        val recording = parse("Time,ID\n" + (0 until 5).joinToString("") { "0.0$it,${9007199254740993L + 2 * it}\n" })
        recording.problems.single().run {
            kind shouldBe ProblemKind.NUMBERS_ROUNDED
            topic shouldBe "ID"
            count shouldBe 5
        }
        parse("a,b\n9007199254740992,1e300\n10000000000000000000,0.12345678901234567890\n").problems.shouldBeEmpty()
    }

    test("a last line without a newline is read in every dialect and in pieces") {
        for (text in listOf("a;b\n1,5;2\n2,5;3", "a\tb\n1,5\t2\n2,5\t3,5", "timestamp,A\n2024-03-16T10:59:58Z,1\n2024-03-16T10:59:59Z,2", "t,v\n1,\"1,234,567\"\n2,\"1,234\"")) {
            val ended = parse("$text\n")
            for (piece in listOf(1, 3, 1000)) {
                val recording = parse(text, piece)
                recording.topics.map { it.samples.toList() } shouldBe ended.topics.map { it.samples.toList() }
                recording.rowCount shouldBe 2
            }
        }
    }

    test("lists in cells between commas do not separate columns, quoted or not") {
        for (list in listOf("[1.5; 2.5; 0.1; 2.5; 3; 0.2]", "1;2;3", "\"1;2;3;4;5;6;7;8;9\"")) {
            val recording = parse("Timestamp,/Poses,Volts\n" + (0 until 9).joinToString("") { "0.0$it,$list,12.$it\n" })
            recording.topics.map { it.name } shouldBe listOf("Timestamp", "/Poses", "Volts")
            recording.topic("Volts").samples[3] shouldBe 12.3
        }
    }

    test("a wall clock beside a time is not the x axis, and a constant date is not a time") {
        val clock = parse("Time,Volts,Wall Clock\n" + (0 until 9).joinToString("") { "0.0$it,12,2024-03-16T10:59:0$it\n" })
        clock.topics.none { "xaxis" in it.attributes } shouldBe true
        clock.values.shouldBeEmpty()
        val built = parse("t,BuildDate\n" + (0 until 9).joinToString("") { "0.0$it,2024-03-16 10:41:07 UTC\n" })
        built.values.shouldBeEmpty()
        built.topic("t").samples[4] shouldBe 0.04
    }

    test("two numbers in one cell are not one number with a mark between thousands") {
        val teams = parse("t,v,teams\n" + (0 until 9).joinToString("") { "0.0$it,1.5,${if (it == 4) "118 254" else "118"}\n" })
        teams.topic("teams").samples.filter { it == 118254.0 }.shouldBeEmpty()
        teams.hints().shouldBeEmpty()
    }

    test("a hole of NULs in a file of another dialect loses only the bytes it covers") {
        val recording = parse("a;b\n1,5;2\n2,5;3\n" + "\u0000".repeat(5000) + "\n4,5;5\n")
        recording.topic("a").samples.filter { it == 4.5 }.size shouldBe 1
        recording.problems.map { it.kind } shouldContain ProblemKind.NUL_HOLE
    }

    test("an ordinary file is not translated") {
        parse("Timestamp,/path,State\n0.0,\"[1; 2; 3]\",a;b\n0.02,\"[1; 2; 3]\",a;c\n").problems.shouldBeEmpty()
        parse("a,b\n1,2\n3,4\n").problems.shouldBeEmpty()
    }
})
