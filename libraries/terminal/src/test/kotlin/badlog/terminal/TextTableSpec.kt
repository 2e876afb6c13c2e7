package badlog.terminal

import badlog.terminal.TextTable.Column
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

    test("wide characters take two columns, marks none") {
        listOf("abc", "\u6a5f\u68b0", "e\u0301", "\uD83E\uDD16").map(::displayWidth) shouldBe listOf(3, 4, 1, 2)
    }

    test("what another program reads is never shortened") {
        val table = TextTable(listOf(Column("NAME", 4), Column("N", 2, isNumber = true)), shortens = false)
        table.lines(listOf(listOf("a long name", "12345"), listOf("b", "1"))).flatten() shouldBe
            listOf("NAME             N", "a long name  12345", "b                1")
        table.line(listOf("a long name", "12345")) shouldBe "a long name  12345"
        table.titles() shouldBe "NAME   N"
    }

    test("a beginning and an end are as long as they may be, and part no character") {
        checkAll(texts, Arb.int(0, 50)) { pieces, width ->
            val text = printable(pieces.joinToString(""))
            for (part in listOf(startOf(text, width), endOf(text, width))) {
                printable(part) shouldBe part
                (displayWidth(part) in minOf(width - 1, displayWidth(text))..width) shouldBe true
            }
        }
    }

    test("no line is wider than the table, and its columns stand below each other") {
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
})
