package badlog.viewer.panel.folder

import badlog.core.analysis.statistics
import badlog.viewer.bagView
import badlog.viewer.panel.Column
import badlog.viewer.panel.Extreme
import badlog.viewer.panel.Field
import badlog.viewer.panel.Row
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Table
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.state.AcrossState
import badlog.viewer.state.FolderAction
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class AcrossLogsSpec : FunSpec({
    fun log(label: String, vararg samples: Double, topic: String = "A", unit: String = "V"): AcrossLog {
        val view = bagView(listOf("Time|xaxis", "A"), samples.mapIndexed { index, value -> "$index,$value" })
        val statistics = view.seriesOf(view.recording.topics.first { it.name == "A" }).statistics()
        return AcrossLog(label, "2026-03-0${samples.size}", "$label.bag", mapOf(topic to statistics), mapOf(topic to unit))
    }

    val state = AcrossState(listOf("A"), setOf(Statistic.MAX, Statistic.MIN))
    val logs = listOf(log("b", 1.0, 5.0), log("A", 2.0), log("none", topic = "B"), log("c", 9.0, 0.5, 1.0))

    fun Column.pressed() = sort.shouldBeInstanceOf<FolderAction.MeasureAcross>().state
    fun table(state: AcrossState, of: List<AcrossLog> = logs) = AcrossLogs(of, state).table()
    fun Table.labels() = rows.map { it.cells.first().single().text }
    fun Table.column(title: String) = columns.first { it.title == title }

    test("a title sorts, and a second press reverses it; rows without a value stay last") {
        val plain = table(state)
        plain.labels() shouldContainExactly listOf("b", "A", "none", "c")
        val ascending = table(plain.column("A\nmax (V)").pressed())
        ascending.labels() shouldContainExactly listOf("A", "b", "c", "none")
        ascending.column("A\nmax (V)").isDescending shouldBe false
        table(ascending.column("A\nmax (V)").pressed()).labels() shouldContainExactly listOf("c", "b", "A", "none")
        table(plain.column("Log").pressed()).labels() shouldContainExactly listOf("A", "b", "c", "none")
        table(plain.column("Date").pressed()).labels() shouldContainExactly listOf("none", "A", "b", "c")
    }

    test("the smallest and the largest value of a column are marked, unless all are the same") {
        fun Table.marks() = rows.map { row -> row.cells.last().single().extreme }
        val most = state.copy(statistics = setOf(Statistic.MAX))
        table(most).marks() shouldContainExactly listOf(null, Extreme.SMALLEST, null, Extreme.LARGEST)
        table(most, listOf(logs[0], logs[0])).marks() shouldContainExactly listOf(null, null)
    }

    test("two topics with the same ending keep enough of their titles to differ") {
        val titles = table(AcrossState(listOf("Drive/Left/Speed", "Drive/Right/Speed", "Arm/Angle"), setOf(Statistic.MAX)), emptyList()).columns.map { it.title.lines().first() }
        titles shouldContainExactly listOf("Log", "Date", "Left/Speed", "Right/Speed", "Angle")
        table(state).columns.last().hint shouldBe "A max"
    }

    test("the CSV has exact values, and quotes where necessary") {
        val odd = log("He said \"1,2\"\nand left", 1 / 3.0)
        AcrossLogs(listOf(odd, logs[2]), AcrossState(listOf("A"), setOf(Statistic.MAX))).csv() shouldBe
            "Log,Date,File,A max (V)\r\n" +
            "\"He said \"\"1,2\"\"\nand left\",2026-03-01,\"He said \"\"1,2\"\"\nand left.bag\",0.3333333333333333\r\n" +
            "none,2026-03-00,none.bag,\r\n"
    }

    test("logs with a topic in different units each show their own unit") {
        val mixed = AcrossLogs(listOf(logs[0], log("mV", 900.0, unit = "mV")), AcrossState(listOf("A"), setOf(Statistic.MAX)))
        mixed.table().columns.last().title shouldBe "A\nmax"
        mixed.table().rows[1].cells.last().single().text shouldBe "900 mV"
        mixed.csv().lines()[0] shouldBe "Log,Date,File,A max,A max unit"
        mixed.csv().lines()[2] shouldBe "mV,2026-03-01,mV.bag,900,mV"
    }

    test("the chosen topics come before those that a search found, and a press chooses another or removes it") {
        val (field, rows) = acrossTopics(state.copy(search = "z"), listOf("Z", "A"))
        (field as Field).text shouldBe "z"
        val topics = (rows as Rows).rows.map { it as Row }
        topics.map { it.title to it.isCurrent } shouldContainExactly listOf("A" to true, "Z" to false)
        topics.map { it.open.shouldBeInstanceOf<FolderAction.MeasureAcross>().state.topics } shouldContainExactly listOf(emptyList(), listOf("A", "Z"))
    }
})
