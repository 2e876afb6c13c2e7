package badlog.window.sidebar

import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.Statistic
import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import java.nio.file.Path

class StatisticsGridSpec : FunSpec({
    fun row(label: String, vararg samples: Double, topic: String = "A", unit: String = "V"): StatisticsRow {
        val bag = bagOf(listOf("Time|xaxis", topic), samples.mapIndexed { index, value -> "$index,$value" })
        val row = statisticsRow(recordingOf(bag, "$label.bag"), listOf(topic), "")
        return StatisticsRow(label, "2026-03-0${samples.size}", Path.of("$label.bag"), row.statistics, row.units.mapValues { unit })
    }

    val maximum = FigureColumn("A", Statistic.MAX)
    val choice = StatisticsChoice(listOf("A"), setOf(Statistic.MAX, Statistic.MIN))
    val rows = listOf(row("b", 1.0, 5.0), row("A", 2.0), row("none", topic = "B"), row("c", 9.0, 0.5, 1.0))

    fun labels(choice: StatisticsChoice) = StatisticsGrid(rows, choice).rows.map { it.label }

    test("a heading sorts, and a second click reverses it; rows without a value stay last") {
        labels(choice) shouldContainExactly listOf("b", "A", "none", "c")
        labels(choice.sortedBy(maximum)) shouldContainExactly listOf("A", "b", "c", "none")
        labels(choice.sortedBy(maximum).sortedBy(maximum)) shouldContainExactly listOf("c", "b", "A", "none")
        labels(choice.sortedBy(LabelColumn)) shouldContainExactly listOf("A", "b", "c", "none")
        labels(choice.sortedBy(DateColumn)) shouldContainExactly listOf("none", "A", "b", "c")
    }

    test("the smallest and the largest value of a column are highlighted, unless all are the same") {
        val grid = StatisticsGrid(rows, choice)
        rows.filter { grid.isLowest(maximum, it) }.map { it.label } shouldContainExactly listOf("A")
        rows.filter { grid.isHighest(maximum, it) }.map { it.label } shouldContainExactly listOf("c")
        val same = StatisticsGrid(listOf(rows[0], rows[0]), choice)
        same.isLowest(maximum, rows[0]) shouldBe false
    }

    test("two topics with the same ending keep enough of their headings to differ") {
        val grid = StatisticsGrid(emptyList(), choice.copy(topics = listOf("Drive/Left/Speed", "Drive/Right/Speed", "Arm/Angle")))
        grid.columns.filterIsInstance<FigureColumn>().map(grid::nameOf).distinct() shouldContainExactly listOf("Left/Speed", "Right/Speed", "Angle")
    }

    test("the CSV has exact values, and quotes where necessary") {
        val odd = row("He said \"1,2\"\nand left", 1 / 3.0)
        StatisticsGrid(listOf(odd, rows[2]), StatisticsChoice(listOf("A"), setOf(Statistic.MAX))).toCsv() shouldBe
            "Log,Date,File,A max (V)\r\n" +
            "\"He said \"\"1,2\"\"\nand left\",2026-03-01,\"He said \"\"1,2\"\"\nand left.bag\",0.3333333333333333\r\n" +
            "none,2026-03-00,none.bag,\r\n"
    }

    test("recordings that log a topic in different units each show their own unit") {
        val mixed = StatisticsGrid(listOf(rows[0], row("mV", 900.0, unit = "mV")), StatisticsChoice(listOf("A"), setOf(Statistic.MAX)))
        mixed.unitOf(maximum) shouldBe null
        mixed.textOf(maximum, mixed.rows[1]) shouldBe "900 mV"
        mixed.toCsv().lines()[0] shouldBe "Log,Date,File,A max,A max unit"
        mixed.toCsv().lines()[2] shouldBe "mV,2026-03-01,mV.bag,900,mV"
    }

    test("any text can be read from its cell again") {
        checkAll(Arb.string()) { text ->
            val cell = csvCell(text)
            val read = if (cell.startsWith('"')) cell.drop(1).dropLast(1).replace("\"\"", "\"") else cell
            read shouldBe text
        }
    }

    test("a drawn log of the folder has one row, with the folder's date and all its signals") {
        val open = recordingOf(bagOf(listOf("Time|xaxis", "A|delta", "Mode"), listOf("0,1,on", "1,4,on")), "open.bag")
        val inFolder = StatisticsRow("open", "2026-03-14 10:41", open.file, rows[0].statistics, rows[0].units)
        val source = statisticsSource(listOf(open), listOf(inFolder, rows[2], row("d", 7.0, topic = "Z")))
        source.topics shouldContainExactly listOf("A", "A Delta", "Z")
        source.topicsFoundBy(Query("has:finding | is:constant"), setOf("A")) shouldContainExactly listOf("A")
        source.topicsFoundBy(Query("is:number -has:finding"), setOf("A")) shouldContainExactly listOf("A Delta", "Z")
        val made = source.rowsOf(listOf("A", "A Delta"))
        made.map { it.label } shouldContainExactly listOf("open.bag", "none", "d")
        made[0].date shouldBe "2026-03-14 10:41"
        made[0].statistics.keys shouldBe setOf("A", "A Delta")
    }
})
