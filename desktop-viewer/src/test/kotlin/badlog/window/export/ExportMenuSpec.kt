package badlog.window.export

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onFirst
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.Span
import badlog.files.UserFolders
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.change
import badlog.window.files.ChosenFiles
import badlog.window.waiting.waitForNotice
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlinx.coroutines.MainScope
import java.nio.file.Files
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class ExportMenuSpec : FunSpec({
    val home = tempdir().toPath()
    val log = Files.writeString(home.resolve("match.bag"), armBag(500))

    fun window(chosen: Path?, hasLog: Boolean = true, test: ComposeUiTest.(Viewer, ChosenFiles) -> Unit) {
        val files = ChosenFiles(chosen)
        runDesktopComposeUiTest(1200, 900) {
            val viewer = Viewer(MainScope(), UserFolders(home, home), files = files)
            if (hasLog) {
                val recording = recordingOf(armBag(500), log)
                viewer.current.replace(recording)
                viewer.board.replace(defaultBoard(recording.view))
                viewer.view.send(PlaceAction.Open(recording.span))
            }
            setContent { ViewerScreen(viewer) }
            test(viewer, files)
        }
    }

    fun ComposeUiTest.choose(menu: String, entry: String) {
        onNodeWithText(menu).performClick()
        onNodeWithContentDescription(entry).performClick()
    }

    test("without a log, every entry that needs one is disabled and says why") {
        window(null, hasLog = false) { _, _ ->
            onNodeWithText("Export").performClick()
            onNodeWithContentDescription("Export the page of this log…").assertIsNotEnabled()
            onNodeWithContentDescription("Figure for a report…").assertIsNotEnabled()
            onNodeWithContentDescription("The visible range as CSV…").assertIsNotEnabled()
            onAllNodesWithText("Open a log first.").onFirst().assertExists()
            onNodeWithText("Check logs in the list first.").assertExists()
            onNodeWithText("Open a folder first.").assertExists()
        }
    }

    test("the page of the open log is written to the file that the person names") {
        val page = home.resolve("page.html")
        window(page) { viewer, _ ->
            choose("Export", "Export the page of this log…")
            waitForNotice(viewer, "Saved $page")
            Files.readString(page).lowercase() shouldStartWith "<!doctype html>"
        }
    }

    test("a figure is saved with its options and the values at the pinned cursor, and its file is reported") {
        val file = home.resolve("figure.svg")
        window(file) { viewer, files ->
            viewer.view.send(PlaceAction.GoTo(1.0))
            choose("Export", "Figure for a report…")
            onNodeWithText("3 of 3 graphs").assertExists()
            onNodeWithContentDescription("In the figure: Arm/Current").performClick()
            onNodeWithContentDescription("File: SVG").performClick()
            onNodeWithContentDescription("Width: 600").performClick()
            onNodeWithContentDescription("Save the figure").performClick()
            waitForNotice(viewer, "Saved $file")
            val svg = Files.readString(file)
            svg shouldContain "width=\"600\""
            svg shouldContain "Arm/Angle"
            svg shouldContain "match.bag · 0.00"
            svg shouldContain " s · cursor at 1.00"
            ("Arm/Current" in svg) shouldBe false
            files.questions shouldBe listOf("Save the figure")
        }
    }

    test("the selection is saved instead of the visible range, also for the topics of the graphs only, with their units") {
        val file = home.resolve("part.csv")
        window(file) { viewer, files ->
            viewer.view.send(PlaceAction.Select(Span(1.0, 1.1)))
            choose("Export", "The selection as CSV…")
            waitForNotice(viewer, "Wrote 6 rows to $file")
            Files.readAllLines(file).size shouldBe 7
            val table = home.resolve("board.csv")
            files.file = table
            viewer.board.change { without(graphs.first { "Arm/Angle" in it.lines }.id) }
            choose("Export", "The graphs as CSV…")
            waitForNotice(viewer, "Wrote 6 rows to $table")
            Files.readAllLines(table).first() shouldBe "Time (s),Arm/Current (A),Arm/Mode"
        }
    }
})
