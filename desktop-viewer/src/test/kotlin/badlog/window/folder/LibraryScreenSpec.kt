package badlog.window.folder

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.click
import androidx.compose.ui.test.doubleClick
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.bag
import badlog.catalog.folder.put
import badlog.catalog.folder.putSamples
import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.app.libraryCommands
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class LibraryScreenSpec : FunSpec({
    fun onFolder(folder: Path, main: MainView = MainView.GRAPHS, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        viewer.panels.change { copy(main = main) }
        runDesktopComposeUiTest(1600, 800) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.newest.run() }
            viewer.library.open(folder)
            waitFor {
                viewer.library.state.hasLooked && viewer.library.state.reading == null &&
                    (viewer.current.recording != null || viewer.library.state.newest == null)
            }
            try {
                steps(viewer)
            } finally {
                viewer.library.close()
            }
        }
    }

    fun sampleFolder() = tempdir().toPath().also { it.putSamples() }

    fun shown(viewer: Viewer) = viewer.library.state.visible.map { it.title }

    test("the samples are listed with their matches, a click opens one, and page up the one above it") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithText("Q42 · Mill Creek").assertExists()
            onNodeWithText("16 Mar 2024").assertExists()
            onNodeWithText("10:41 · 2:36 · 6.73 V", substring = true).assertExists()
            onNodeWithContentDescription("Log practice.bag").performClick()
            waitFor { viewer.current.recording?.file?.fileName.toString() == "practice.bag" }
            onNodeWithContentDescription("Log practice.bag").assertIsSelected()
            viewer.library.change { copy(selected = visible[1].file) }
            libraryCommands(viewer.library, viewer.panels, viewer.opener, viewer::showNewLog).single { it.keys.single().key == Key.PageUp }.action()
            waitFor { viewer.current.recording?.file == viewer.library.state.visible[0].file }
        }
    }

    test("a click on what happened in the list opens the log at its evidence") {
        onFolder(sampleFolder()) { viewer ->
            waitFor { onAllNodesWithContentDescription("error: Browned out", substring = true).fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("error: Browned out", substring = true).performClick()
            waitFor { viewer.current.recording?.file?.fileName.toString() == "qualification-42.bag" }
            viewer.panels.state.inspector shouldBe InspectorTab.FINDINGS
        }
    }

    test("a search lists the logs that have all words, and can be cleared") {
        onFolder(sampleFolder()) { viewer ->
            viewer.commands.first { it.meaning == "Search the logs" }.action()
            onNodeWithContentDescription("Search logs").assertIsFocused()
            onNodeWithContentDescription("Search logs").performTextInput("qual blue")
            shown(viewer) shouldContainExactly listOf("Qualification 42")
            onNodeWithText("1 of 4 logs").assertExists()
            onNodeWithContentDescription("Search logs").performKeyInput { pressKey(Key.Enter) }
            waitFor { viewer.current.recording?.file?.fileName.toString() == "qualification-42.bag" }
            onNodeWithContentDescription("Search logs").performTextInput(" nothing")
            onNodeWithText("List all logs").performClick()
            shown(viewer).size shouldBe 4
        }
    }

    test("a tick adds a log to the comparison, or removes it") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithContentDescription("Compare practice.bag").performClick()
            viewer.compared.state.checked.map { "${it.fileName}" } shouldContainExactly listOf("practice.bag")
            onNodeWithContentDescription("Compare practice.bag").performClick()
            viewer.compared.state.checked.size shouldBe 0
        }
    }

    test("keys move through the table, Enter and a double click open the log in the graphs, and a click selects a row") {
        onFolder(sampleFolder(), MainView.LOGS) { viewer ->
            val table = onNodeWithContentDescription("Table of logs")
            table.performKeyInput { pressKey(Key.MoveHome) }
            viewer.library.state.selected shouldBe viewer.library.state.visible[0].file
            table.performKeyInput { pressKey(Key.DirectionDown) }
            val second = viewer.library.state.visible[1].file
            viewer.library.state.selected shouldBe second
            table.performKeyInput { pressKey(Key.Enter) }
            waitFor { viewer.current.recording?.file == second }
            viewer.panels.state.main shouldBe MainView.GRAPHS
            viewer.panels.change { copy(main = MainView.LOGS) }
            waitForIdle()
            onNodeWithContentDescription("Log practice.bag").performMouseInput { click() }
            viewer.library.state.selected?.fileName.toString() shouldBe "practice.bag"
            viewer.panels.state.main shouldBe MainView.LOGS
            onNodeWithContentDescription("Log practice.bag").performMouseInput { doubleClick() }
            viewer.panels.state.main shouldBe MainView.GRAPHS
        }
    }

    test("an unreadable log is reported and not opened") {
        val folder = tempdir().toPath()
        folder.put("diary.bag", "Dear diary\ntoday I was happy\n")
        onFolder(folder) { viewer ->
            onNodeWithContentDescription("Log diary.bag").performClick()
            viewer.current.recording shouldBe null
            viewer.notices.all.single().isError shouldBe true
        }
    }

    test("the preview can show any topic of any log") {
        onFolder(sampleFolder()) { viewer ->
            onNodeWithContentDescription("Preview: the battery’s voltage").performClick()
            onNodeWithContentDescription("Search topics for the preview").performTextInput("pos elevator/")
            onNode(hasText("Elevator/Position")).performClick()
            viewer.settings.state.previewTopic shouldBe "Elevator/Position"
        }
    }
})
