package badlog.viewer.library

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertCountEquals
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.click
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.app.Viewer
import badlog.viewer.app.ViewerScreen
import badlog.viewer.app.askForSearch
import badlog.viewer.app.libraryCommands
import badlog.viewer.panels.MainView
import badlog.viewer.settings.UserFolders
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
class LibraryScreenSpec : FunSpec({
    fun onFolder(folder: Path, main: MainView = MainView.GRAPHS, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        viewer.panels = viewer.panels.copy(main = main)
        runDesktopComposeUiTest(1600, 800) {
            setContent { ViewerScreen(viewer) }
            viewer.libraryFolder.open(folder)
            waitUntil(timeoutMillis = 30_000) {
                viewer.library.hasLooked && viewer.library.reading == null &&
                    (viewer.open != null || viewer.library.newest == null)
            }
            try {
                steps(viewer)
            } finally {
                viewer.libraryFolder.close()
            }
        }
    }

    fun sampleFolder() = tempdir().toPath().also { it.putSamples() }

    fun shown(viewer: Viewer) = viewer.library.visible.map { it.title }

    test("the samples are listed with their matches, and a click opens one") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithText("Qualification 42", substring = true).assertExists()
            onNodeWithText("16 Mar 2024, 10:41 · 2:36 · 6.7 V").assertExists()
            onNodeWithContentDescription("Log practice.bag").performClick()
            waitUntil(timeoutMillis = 30_000) { viewer.open?.file?.fileName.toString() == "practice.bag" }
            onNodeWithContentDescription("Log practice.bag").assertIsSelected()
        }
    }

    test("a search leaves what has all words, and can be taken back") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithContentDescription("Search logs").performTextInput("qual blue")
            shown(viewer) shouldContainExactly listOf("Qualification 42")
            onNodeWithText("1 of 4 logs").assertExists()
            onNodeWithContentDescription("Search logs").performKeyInput { pressKey(Key.Enter) }
            waitUntil(timeoutMillis = 30_000) { viewer.open?.file?.fileName.toString() == "qualification-42.bag" }
            onNodeWithContentDescription("Search logs").performTextInput(" nothing")
            onNodeWithText("List all logs").performClick()
            shown(viewer).size shouldBe 4
        }
    }

    test("the slash puts the keyboard into the search") {
        onFolder(sampleFolder()) { viewer ->
            viewer.askForSearch()
            onNodeWithContentDescription("Search logs").assertIsFocused()
        }
    }

    test("a tick takes a log into the comparison and out of it") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithContentDescription("Compare practice.bag").performClick()
            viewer.comparison.ticked.map { "${it.fileName}" } shouldContainExactly listOf("practice.bag")
            onNodeWithContentDescription("Compare practice.bag").performClick()
            viewer.comparison.ticked.size shouldBe 0
        }
    }

    test("clicks on the heads of the table sort it, either way round") {
        onFolder(sampleFolder(), MainView.LOGS) { viewer ->
            onNodeWithContentDescription("Sort by Match").performClick()
            shown(viewer).take(2) shouldContainExactly listOf("Qualification 42", "Qualification 57")
            onNodeWithContentDescription("Sort by Match").performClick()
            shown(viewer).take(2) shouldContainExactly listOf("Qualification 57", "Qualification 42")
            onNodeWithContentDescription("Sort by Battery min").performClick()
            shown(viewer).first() shouldBe "Qualification 42"
            shown(viewer).last() shouldBe "elevator-bench.csv"
        }
    }

    test("the keyboard goes through the table, and Enter opens the log in the graphs") {
        onFolder(sampleFolder(), MainView.LOGS) { viewer ->
            val table = onNodeWithContentDescription("Table of logs")
            table.performKeyInput { pressKey(Key.MoveHome) }
            viewer.library.selected shouldBe viewer.library.visible[0].file
            table.performKeyInput { pressKey(Key.DirectionDown) }
            val second = viewer.library.visible[1].file
            viewer.library.selected shouldBe second
            table.performKeyInput { pressKey(Key.Enter) }
            waitUntil(timeoutMillis = 30_000) { viewer.open?.file == second }
            viewer.panels.main shouldBe MainView.GRAPHS
        }
    }

    test("a click on a row of the table selects it, a double click opens it") {
        onFolder(sampleFolder(), MainView.LOGS) { viewer ->
            onNodeWithContentDescription("Log practice.bag").performMouseInput { click() }
            viewer.library.selected?.fileName.toString() shouldBe "practice.bag"
            viewer.panels.main shouldBe MainView.LOGS
            onNodeWithContentDescription("Log practice.bag").performMouseInput { doubleClick() }
            viewer.panels.main shouldBe MainView.GRAPHS
        }
    }

    test("logs where nothing happened say so, and can be hidden") {
        val folder = sampleFolder()
        folder.put("reboot.bag", bag(0))
        folder.put("idle.bag", bag(voltage = { 12.0 }))
        onFolder(folder) { viewer ->
            onNodeWithText("no samples", substring = true).assertExists()
            onNodeWithText("nothing happened here", substring = true).assertExists()
            onNodeWithContentDescription("Hide logs where nothing happened").performClick()
            shown(viewer).size shouldBe 4
            onAllNodesWithText("nothing happened here", substring = true).assertCountEquals(0)
        }
    }

    test("a log that cannot be read is complained of, not opened") {
        val folder = tempdir().toPath()
        folder.put("diary.bag", "Dear diary\ntoday I was happy\n")
        onFolder(folder) { viewer ->
            onNodeWithContentDescription("Log diary.bag").performClick()
            viewer.open shouldBe null
            viewer.notices.all.single().isError shouldBe true
        }
    }

    test("an empty folder says what badlog looks for") {
        onFolder(tempdir().toPath()) { onNodeWithText("No logs here yet", substring = true).assertExists() }
    }

    test("the small line can be that of any topic of any log") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithContentDescription("Small line: the battery’s voltage").performClick()
            onNodeWithContentDescription("Search topics for the small line").performTextInput("elevator/pos")
            onNode(hasText("Elevator/Position")).performClick()
            viewer.settings.previewTopic shouldBe "Elevator/Position"
        }
    }

    test("page up and page down open the logs one after the other") {
        onFolder(sampleFolder()) { viewer ->
            viewer.library = viewer.library.copy(selected = viewer.library.visible[1].file)
            libraryCommands(viewer).single { it.keys.single().key == Key.PageUp }.action()
            waitUntil(timeoutMillis = 30_000) { viewer.open?.file == viewer.library.visible[0].file }
        }
    }
})
