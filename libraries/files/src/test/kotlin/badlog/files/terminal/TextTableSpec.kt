package badlog.files.terminal

import badlog.files.terminal.TextTable.Column
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

private val PIECES = listOf("a", " ", "word", "\u00e9", "e\u0301", "\u6a5f", "\uD83E\uDD16", "\u202e", "\u001b", "\n")

class TextTableSpec : FunSpec({
    val texts = Arb.list(Arb.element(PIECES), 0..40)

    test("wide characters take two columns, combining marks none") {
        listOf("abc", "\u6a5f\u68b0", "e\u0301", "\uD83E\uDD16").map(::displayWidth) shouldBe listOf(3, 4, 1, 2)
    }

    test("a table for another program is never shortened") {
        val table = TextTable(listOf(Column("NAME", 4), Column("N", 2, isNumber = true)), shortens = false)
        table.lines(listOf(listOf("a long name", "12345"), listOf("b", "1"))).flatten() shouldBe
            listOf("NAME             N", "a long name  12345", "b                1")
        table.line(listOf("a long name", "12345")) shouldBe "a long name  12345"
        table.titles() shouldBe "NAME   N"
    }

    test("a beginning and an end are as long as they may be, and split no character") {
        checkAll(texts, Arb.int(0, 50)) { pieces, width ->
            val text = printable(pieces.joinToString(""))
            for (part in listOf(startOf(text, width), endOf(text, width))) {
                printable(part) shouldBe part
                (displayWidth(part) in minOf(width - 1, displayWidth(text))..width) shouldBe true
            }
        }
    }

    test("no line is wider than the table, and its columns are aligned") {
        checkAll(Arb.list(Arb.list(texts, 3..3), 1..5)) { rows ->
            val table = TextTable(listOf(Column("A"), Column("B"), Column("C")), 60)
            val lines = table.lines(rows.map { cells -> cells.map { it.joinToString("") } }).flatten()
            lines.filter { displayWidth(it) > 60 }.shouldBeEmpty()
            lines.filter { printable(it) != it }.shouldBeEmpty()
        }
    }

    test("a cell that is too long loses its middle") {
        TextTable.shortened("samples/qualification-42.bag", 20) shouldBe "sampl…ication-42.bag"
        val narrow = TextTable(listOf(Column("NAME", 6), Column("N", 3, isNumber = true)))
        narrow.line(listOf("\u6a5f\u68b0\u6a5f\u68b0", "7")) shouldBe "\u6a5f…\u68b0     7"
    }

    test("values are never shortened, whatever the width: names are shortened first, then columns go below each other") {
        val numbers = Arb.int(0, 1_000_000_000)
        checkAll(Arb.element(60, 80, 100, 200), Arb.list(texts, 2..2), Arb.list(numbers, 1..12)) { width, names, values ->
            val columns = listOf(Column("Match"), Column("File")) + values.map { Column("a title that is long", isNumber = true) }
            val cells = names.map { it.joinToString("") } + values.map { "$it" }
            val lines = TextTable(columns, width, repeated = 2).text(listOf(cells))
            lines.filter { displayWidth(it) > width }.shouldBeEmpty()
            val shown = lines.joinToString(" ").split(' ')
            values.filter { "$it" !in shown }.shouldBeEmpty()
        }
    }

    test("columns that do not fit are in another block below, beside the first ones again") {
        val columns = listOf(Column("Match"), Column("A", isNumber = true), Column("B", isNumber = true))
        val rows = listOf(listOf("Q1", "1.23456789", "2.3456789"), listOf("Q2", "1", "2"))
        TextTable(columns, 17, repeated = 1).text(rows) shouldBe listOf(
            "Match           A",
            "Q1     1.23456789",
            "Q2              1",
            "",
            "Match          B",
            "Q1     2.3456789",
            "Q2             2",
        )
    }
})
