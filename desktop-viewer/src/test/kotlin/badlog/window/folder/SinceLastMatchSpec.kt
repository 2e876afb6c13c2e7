package badlog.window.folder

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertCountEquals
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.putSamples
import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.rules.BUILT_IN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.number.FigureText
import badlog.rules.number.MatchKind
import badlog.rules.number.Measure
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogFound
import badlog.viewer.catalog.LogSummary
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.sidebar.InspectorTab
import badlog.window.waiting.waitFor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.MainScope
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
class SinceLastMatchSpec : FunSpec({
    fun log(name: String, second: Long) = LogEntry(
        LogFile(Path.of("/logs/$name"), 1, 1),
        LogSummary(date = LogDate(second, DateSource.VALUES), content = Content.SOMETHING),
        LogFound(0, emptyList()),
    )

    /** A log whose motor was as hot as [celsius]. */
    fun examined(celsius: Double, kind: MatchKind = MatchKind.MATCH) = FigureText(
        "motor temperature\tArm/Temperature\t${Measure.HIGHEST.ordinal}\t°C",
        "${kind.ordinal};NaN;false;false;$celsius",
    ).let { ExaminedLog(null, emptyList(), emptyList(), null, figureNames = it.names, figureValues = it.values) }

    val logs = List(8) { log("$it.bag", it.toLong()) }

    test("a log that is unlike the matches before it says how") {
        val temperatures = listOf(41.0, 40.0, 42.0, 39.5, 41.5, 40.5, 95.0)
        val changes = changesOf(logs[6], logs.take(6), RuleSet.BUILT_IN) { examined(temperatures[logs.indexOf(it)]) }
        changes.differences.single().text shouldContain "Arm/Temperature at its highest was 95 °C"
        changes.previous shouldBe logs[5].file
    }

    test("a log like the others, or with too few before it, says nothing") {
        changesOf(logs[6], logs.take(6), RuleSet.BUILT_IN) { examined(40.0 + logs.indexOf(it) % 3) }.differences.shouldBeEmpty()
        changesOf(logs[3], logs.take(3), RuleSet.BUILT_IN) { examined(if (it === logs[3]) 95.0 else 40.0) }.differences.shouldBeEmpty()
        changesOf(logs[0], emptyList(), RuleSet.BUILT_IN) { examined(95.0) } shouldBe Changes()
    }

    test("only matches before count, neither practice nor another log of the same match, and of them the last 20") {
        val many = List(40) { log("$it.bag", it.toLong()) }
        earlierThan(many[25], many.shuffled()).map { it.summary.date.second } shouldBe (0L..24L).toList()
        val match = MatchOfLog(null, "Qualification", "7")
        fun LogEntry.of(match: MatchOfLog) = copy(summary = summary.copy(match = match))
        earlierThan(many[1].of(match), listOf(many[0].of(match))).shouldBeEmpty()

        var read = 0
        val changes = changesOf(many[39], many.take(39), RuleSet.BUILT_IN) {
            read++
            if (it === many[38]) examined(40.0, MatchKind.PRACTICE) else examined(if (it === many[39]) 95.0 else 40.0 + read % 3)
        }
        changes.differences.single().text shouldContain "your 20 other matches"
        changes.previous shouldBe many[37].file
    }

    test("a click on what is different shows it over the match before") {
        val home = tempdir().toPath()
        val folder = tempdir().toPath().also { it.putSamples() }
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val before = folder.resolve("practice.bag")
        runDesktopComposeUiTest(1366, 768) {
            setContent { ViewerScreen(viewer) }
            viewer.loader.open(folder.resolve("qualification-42.bag"))
            waitFor { viewer.current.recording != null }
            viewer.findings.change { knowing(badlog.window.findings.FindingList()) }
            viewer.panels.change { inspecting(InspectorTab.FINDINGS) }
            waitForIdle()
            onAllNodesWithContentDescription("Unlike the matches before").assertCountEquals(0)
            val hot = Finding("Unlike other matches", Severity.WARNING, "Arm/Angle", "The arm was hot.", Double.NaN, emptyList(), 1, "")
            viewer.since.change { Changes(listOf(hot), before) }
            onNodeWithText("The arm was hot.").performClick()
            waitFor { viewer.compared.state.loaded.isNotEmpty() }
            viewer.compared.state.checked shouldBe listOf(before)
            viewer.board.evidence.graphs.shouldHaveSize(1).single().lines.first() shouldBe "Arm/Angle"
        }
    }
})
