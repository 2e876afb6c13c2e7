package badlog.window.todo

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assert
import androidx.compose.ui.test.assertIsOff
import androidx.compose.ui.test.assertIsOn
import androidx.compose.ui.test.hasStateDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.putSamples
import badlog.catalog.todo.TodoFolder
import badlog.catalog.todo.newChange
import badlog.exporter.NotesFile
import badlog.files.UserFolders
import badlog.viewer.choices.note.Note
import badlog.viewer.todo.NoteTask
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.lines
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.files.ChosenFiles
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.MainView
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class TodoPaneSpec : FunSpec({
    fun onFolder(main: MainView = MainView.TODO, page: Path? = null, steps: DesktopComposeUiTest.(Viewer, Path) -> Unit) {
        val home = tempdir().toPath()
        val folder = tempdir().toPath().also { it.putSamples(areSettled = true) }
        folder.resolve("checklist.md").writeText("# Before each match\n- [ ] Bumpers are tight\n")
        val viewer = Viewer(MainScope(), UserFolders(home, home), files = ChosenFiles(page))
        viewer.panels.change { copy(main = main) }
        viewer.settings.change { copy(author = "Ada") }
        runDesktopComposeUiTest(1366, 900) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.todo.run() }
            viewer.library.open(folder)
            // The list changes with each log that the rules have examined.
            waitFor {
                val state = viewer.library.state
                val logs = state.ofRobots.filter { !it.isGray }
                val areExamined = state.hasLooked && state.entries.size == state.files.size && logs.all { it.found?.rules != null }
                areExamined && viewer.todo.state.logs.size == logs.size && viewer.todo.state.lines.size > 1
            }
            try {
                steps(viewer, folder)
            } finally {
                viewer.library.close()
            }
        }
    }

    fun open(viewer: Viewer) = viewer.todo.state.list.open.map { it.title }

    test("an error is listed by itself, marked as done in a dialog, and its line is in the file") {
        onFolder { viewer, folder ->
            val title = open(viewer).first()
            onNodeWithContentDescription("Mark as done: $title").performClick()
            onNodeWithContentDescription("What was done").performTextInput("replaced main breaker")
            onNodeWithContentDescription("Before which match").performTextReplacement("q58")
            onNodeWithContentDescription("By whom").performKeyInput { pressKey(Key.Enter) }
            onNodeWithContentDescription("Mark as done: $title sheet").assertDoesNotExist()
            (title in open(viewer)) shouldBe false
            onNodeWithText("Done: 1").assert(hasStateDescription("collapsed")).performClick().assert(hasStateDescription("expanded"))
            onNodeWithText("Done before Qualification 58 by Ada: replaced main breaker").assertExists()
            val file = TodoFolder(folder).file
            waitFor { file.exists() && file.readText().endsWith("\n") }
            file.readText() shouldContain "\"what\":\"replaced main breaker\",\"before\":\"Qualification 58\""
            onNodeWithContentDescription("Not done: $title").performClick()
            (title in open(viewer)) shouldBe true
        }
    }

    test("an own item is added and assigned, the item of another laptop appears, and the checklist is ticked for one match") {
        onFolder { viewer, folder ->
            onNodeWithContentDescription("New item").performClick()
            onNodeWithContentDescription("What is to be done").performTextInput("Check the radio")
            onNodeWithContentDescription("Who takes it on; nobody if empty").performTextInput("Ben")
            onNodeWithContentDescription("Add (Enter)").performClick()
            onNodeWithText("To do: Ben").assertExists()
            TodoFolder(folder, "other").append(newChange(OwnTask("Tighten bumpers"), TodoDeed.Open, "Cem", last = null))
            waitFor { "Tighten bumpers" in open(viewer) }
            onNodeWithText("Tighten bumpers").assertExists()
            onNodeWithContentDescription("Check: Bumpers are tight").performClick()
            onNodeWithContentDescription("Check: Bumpers are tight").assertIsOn()
            onNodeWithContentDescription("Set the next match").performClick()
            onNodeWithContentDescription("Next match, such as Qualification 61 or q61").performTextInput("q61")
            onNodeWithContentDescription("Set (Enter)").performClick()
            onNodeWithText("Checklist before Qualification 61").assertExists()
            onNodeWithContentDescription("Check: Bumpers are tight").assertIsOn().performClick().assertIsOff().performClick()
            onNodeWithContentDescription("Set the next match").performClick()
            onNodeWithContentDescription("Next match, such as Qualification 61 or q61").performTextReplacement("62")
            onNodeWithContentDescription("Set (Enter)").performClick()
            onNodeWithText("Checklist before Qualification 62").assertExists()
            onNodeWithContentDescription("Check: Bumpers are tight").assertIsOff()
            waitFor { viewer.todo.state.written.isEmpty() }
            viewer.todo.state.files.changes shouldHaveSize 8
        }
    }

    test("a note of the open log is added to the list") {
        onFolder(MainView.GRAPHS) { viewer, folder ->
            viewer.scope.launch { viewer.notes.run() }
            val log = folder.resolve("practice.bag")
            NotesFile.update(log, listOf(Note(1.5, "It smells burnt.")), read = emptyList())
            viewer.panels.change { copy(inspector = InspectorTab.NOTES) }
            viewer.opener.open(viewer.library.state.entries.first { it.file == log })
            waitFor { viewer.notes.all.isNotEmpty() }
            onNodeWithContentDescription("Put on the list: It smells burnt.").performClick()
            val item = viewer.todo.state.list.item(NoteTask("practice.bag", 1.5, "It smells burnt."))
            item?.lines shouldBe listOf("A note in practice.bag.")
        }
    }
})
