package badlog.window.battery

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onLast
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.LogEntry
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.sidebar.MainView
import badlog.window.waiting.waitFor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
class BatteriesPaneSpec : FunSpec({
    fun entry(folder: Path, match: Int, battery: String?, milliohms: Double) = LogEntry(
        LogFile(folder.resolve("q$match.bag"), 1000, 1000L * match),
        LogSummary(
            MatchOfLog(type = "Qualification", number = "$match"),
            LogDate(7200L * match, DateSource.VALUES),
            content = Content.SOMETHING,
            battery = BatteryUse(battery, "Battery", 8.5, 12.8, null, null, Resistance(milliohms, 0.4)),
        ),
    )

    fun onFolder(steps: DesktopComposeUiTest.(Viewer, Path) -> Unit) {
        val home = tempdir().toPath()
        val folder = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        runDesktopComposeUiTest(1366, 768) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.batteries.run() }
            val used = listOf("B2" to 30.0, "B2" to 30.0, null to 21.0, "A1" to 20.0, "A1" to 20.2)
            val logs = used.mapIndexed { i, (battery, milliohms) -> entry(folder, i + 1, battery, milliohms) }
            viewer.library.change { copy(folder = folder, hasLooked = true, files = logs.map { it.source }).withEntries(logs) }
            viewer.panels.change { copy(main = MainView.BATTERIES) }
            waitFor { viewer.batteries.state.seasons.size == 3 }
            steps(viewer, folder)
        }
    }

    test("the batteries are listed, a click shows the matches of one, and a battery typed beside a match is stored beside its log") {
        onFolder { viewer, folder ->
            onNodeWithText("Use A1 next").assertExists()
            onAllNodesWithText("Qualification 3").fetchSemanticsNodes().size shouldBe 0
            onNodeWithContentDescription("Battery Unknown").performClick()
            onNodeWithContentDescription("Name… · Qualification 3").performClick()
            onNodeWithContentDescription(NAME).performTextInput("C3")
            onNodeWithContentDescription(NAME).performKeyInput { pressKey(Key.Enter) }
            waitFor { viewer.batteries.state.names == listOf("A1", "B2", "C3") }
            Files.readString(folder.resolve("batteries.toml")) shouldBe "[used]\n\"q3.bag\" = \"C3\"\n"
            onNodeWithContentDescription("Battery C3").performClick()
            onNodeWithContentDescription("Change… · Qualification 3").performClick()
            // The form is above the table.
            onAllNodesWithText("B2").onLast().performClick()
            waitFor { viewer.batteries.state.names == listOf("A1", "B2") }
            Files.readString(folder.resolve("batteries.toml")) shouldBe "[used]\n\"q3.bag\" = \"B2\"\n"
        }
    }

    test("the pit view names the next battery, and a click opens the list") {
        onFolder { viewer, _ ->
            viewer.panels.change { copy(main = MainView.PIT) }
            onNodeWithText("Battery: retire B2").assertExists()
            onNodeWithText("Battery: use A1 next").performClick()
            viewer.panels.state.main shouldBe MainView.BATTERIES
        }
    }
})

private const val NAME = "Name of the battery; leave it empty to use the name in the log"
