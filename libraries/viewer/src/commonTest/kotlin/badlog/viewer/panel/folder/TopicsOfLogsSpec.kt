package badlog.viewer.panel.folder

import badlog.core.analysis.SeriesStatistics
import badlog.core.recording.TopicKind
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Part
import badlog.viewer.panel.Table
import badlog.viewer.shown.folder.AnyLog
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.state.FolderAction
import badlog.viewer.state.TopicsState
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class TopicsOfLogsSpec : FunSpec({
    fun log(path: String, number: String, vararg topics: Pair<String, Double>) = AnyLog(
        path,
        LogSummary(
            MatchOfLog(event = null, type = "Qualification", number = number),
            LogDate(0, DateSource.VALUES),
            duration = 1.0,
            content = Content.SOMETHING,
            topics = topics.map { (name, most) ->
                TopicSummary(name, if (name == "Count") "" else "V", TopicKind.NUMERIC, SeriesStatistics(2, 0, 0.0, most, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0), PreviewLine.NONE)
            },
        ),
        FindingSummary(0, emptyList()),
        modified = 1,
    )

    val one = log("one.bag", "1", "Volts" to 12.0, "Count" to 3.0)
    val two = log("two.bag", "2", "Volts" to 13.0000001)
    val most = TopicsState(Statistic.MAX)
    fun List<Part>.table() = filterIsInstance<Table>().single()
    fun List<Part>.texts() = table().rows.map { row -> row.cells.map { it.single().text } }
    fun Button.state() = action.shouldBeInstanceOf<FolderAction.MeasureTopics>().state

    test("each topic has its statistic in each log; exactly under the pointer") {
        val parts = topicsOfLogs(listOf(one, two), most)
        parts.texts() shouldContainExactly listOf(listOf("Volts [V]", "12", "13"), listOf("Count", "3", ""))
        parts.table().rows[0].cells[2].single().hint shouldBe "13.0000001"
        val choice = parts.filterIsInstance<Choice>().single().options
        choice.single { it.isOn == true }.label shouldBe "max"
        choice.first { it.label == "mean" }.state() shouldBe TopicsState(Statistic.MEAN)
    }

    test("logs of different events with the same match are told apart by their files") {
        topicsOfLogs(listOf(one, two), most).table().columns.map { it.title } shouldContainExactly listOf("Topic", one.title, two.title)
        topicsOfLogs(listOf(one, log("same.bag", "1")), most).table().columns.map { it.title } shouldContainExactly listOf("Topic", "one.bag", "same.bag")
    }

    test("a search leaves only its topics, and a limit those first") {
        topicsOfLogs(listOf(one), most.copy(search = "cou")).texts() shouldContainExactly listOf(listOf("Count", "3"))
        val cut = topicsOfLogs(listOf(one), most.copy(limit = 1))
        cut.table().rows.map { it.name } shouldContainExactly listOf("Volts")
        val more = cut.filterIsInstance<Buttons>().single().buttons.single()
        more.label shouldBe "Show more (1 left)"
        more.state().limit shouldBe 1 + TopicsState.PAGE
    }
})
