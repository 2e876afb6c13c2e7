package badlog.window.welcome

import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.bag
import badlog.catalog.folder.put
import badlog.catalog.folder.samples
import badlog.files.UserFolders
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.files.ChosenFiles
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPInputStream

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class WelcomeSpec : FunSpec({
    fun atFirstStart(chosen: ChosenFiles = ChosenFiles(null), steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home), files = chosen)
        runDesktopComposeUiTest(1366, 768) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.newest.run() }
            try {
                steps(viewer)
            } finally {
                viewer.library.close()
            }
        }
    }

    test("without a log, one click shows a sample match, and remembers no folder for it") {
        atFirstStart { viewer ->
            onNodeWithContentDescription("Open the sample match").performClick()
            waitFor { viewer.current.recording != null }
            viewer.current.recording?.label shouldBe "Mill Creek Regional Qualification 42"
            onNodeWithContentDescription("Welcome").assertDoesNotExist()
            viewer.library.state.folder shouldBe null
            viewer.settings.state.recentFolders.shouldBeEmpty()
            viewer.notices.all.shouldBeEmpty()
        }
    }

    test("closing the sample returns to the welcome, also beside a folder without logs; a log of a folder stays open") {
        val folder = tempdir().toPath()
        val chosen = ChosenFiles(folder)
        atFirstStart(chosen) { viewer ->
            fun openAndCloseSample() {
                onNodeWithContentDescription("Open the sample match").performClick()
                waitFor { viewer.current.recording != null }
                onNodeWithContentDescription("Welcome").assertDoesNotExist()
                viewer.view.send(PlaceAction.Show(10.0, 20.0))
                onNodeWithContentDescription("Folder").performClick()
                onNodeWithText("Close log").performClick()
                onNodeWithContentDescription("Welcome").assertExists()
                viewer.current.recording shouldBe null
                viewer.board.state.graphs.shouldBeEmpty()
            }
            openAndCloseSample()
            onNodeWithContentDescription("Folder").performClick()
            onNodeWithText("Close log").assertDoesNotExist()
            onNodeWithContentDescription("Folder").performClick()
            onNodeWithContentDescription("Open a folder of your logs").performClick()
            waitFor { viewer.library.state.hasLooked }
            openAndCloseSample()
            folder.put("first.bag", bag())
            waitFor { viewer.current.recording != null }
            onNodeWithContentDescription("Welcome").assertDoesNotExist()
            onNodeWithContentDescription("Folder").performClick()
            onNodeWithText("Open folder…").assertExists()
            onNodeWithText("Close log").assertDoesNotExist()
        }
    }

    test("the match that comes with the window equals the sample, and is repaired if it was damaged") {
        val cache = tempdir().toPath()
        val file = SampleLog.unpackInto(cache)
        fun unpacked() = GZIPInputStream(Files.newInputStream(file)).use { it.readAllBytes() }
        unpacked().contentEquals(Files.readAllBytes(samples.resolve("qualification-42.bag"))) shouldBe true
        Files.write(file, ByteArray(10))
        SampleLog.unpackInto(cache) shouldBe file
        unpacked().size.toLong() shouldBe Files.size(samples.resolve("qualification-42.bag"))
    }

    test("each language shows its own lines and its guide") {
        atFirstStart {
            onNodeWithText("log.periodic();").assertExists()
            for (language in LoggingLanguage.entries) {
                onNodeWithContentDescription("Show the lines in ${language.title}").performClick()
                for ((_, code) in language.lines) onNodeWithText(code).assertExists()
                onNodeWithText("docs/${language.guide}", substring = true).assertExists()
            }
        }
    }

    test("every line of a robot’s program is in the program of its guide, which is compiled and run") {
        for (language in LoggingLanguage.entries) {
            val guide = Files.readAllLines(Path.of("../docs", language.guide)).map { it.trim() }
            for (line in language.lines.flatMap { (_, code) -> code.lines() }) guide shouldContain line.trim()
        }
    }
})
