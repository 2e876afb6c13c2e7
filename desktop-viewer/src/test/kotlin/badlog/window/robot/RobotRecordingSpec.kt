package badlog.window.robot

import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.samples
import badlog.core.analysis.LogView
import badlog.exporter.NotesFile
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.networktables.replay.ReplayOptions
import badlog.networktables.replay.ReplayServer
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.withSignals
import badlog.viewer.choices.board.Board
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.change
import badlog.window.waiting.waitFor
import badlog.window.waiting.waitForNotice
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** Returns a robot that repeats a match. */
private fun robot(): ReplayServer {
    val match = LogView.of(readRecording(samples.resolve("qualification-42.bag"), LOG_FORMATS)).withSignals(RuleSet.BUILT_IN.signals, "qualification-42.bag")
    return ReplayServer(match, ReplayOptions(0, speed = 5.0, isLooping = true))
}

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class RobotRecordingSpec : FunSpec({
    fun beside(server: ReplayServer?, folder: Path?, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val address = { _: String -> listOf(RobotAddress("127.0.0.1", emptyList(), networkTablesPort = server?.port ?: 1)) }
        val viewer = Viewer(MainScope(), UserFolders(home, home), robots = address)
        runDesktopComposeUiTest(1600, 800) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.notes.run() }
            if (folder != null) viewer.library.open(folder)
            viewer.robot.change { copy(isShown = true) }
            viewer.panels.change { copy(library = true) }
            waitForIdle()
            onNodeWithContentDescription("Team number or address").performTextInput("1014")
            try {
                steps(viewer)
            } finally {
                viewer.recording.finish()
                viewer.loader.stop()
                viewer.library.close()
            }
        }
    }

    /** Waits until [text] is shown, or until it no longer [isShown]: the window updates a moment later. */
    fun DesktopComposeUiTest.await(text: String, isShown: Boolean = true) = waitFor { onAllNodesWithText(text, substring = true).fetchSemanticsNodes().isNotEmpty() == isShown }

    fun DesktopComposeUiTest.record(choice: String) {
        onNodeWithContentDescription("Record what the robot publishes").performClick()
        onNodeWithText(choice).performClick()
    }

    test("a robot's data is recorded, shown at its newest moment while it grows, and marked; then it is an ordinary log") {
        val folder = tempdir().toPath()
        robot().use { server ->
            server.start()
            beside(server, folder) { viewer ->
                record("Record until stopped")
                waitFor { viewer.current.recording != null }
                val log = viewer.current.recording!!.file
                log.name shouldStartWith "FRC_"
                viewer.live.isStaying shouldBe true
                await("Stop recording")
                val end = viewer.current.recording!!.span.to
                waitFor { viewer.current.recording!!.span.to > end + 0.5 && viewer.view.cursors.pinned == viewer.current.recording!!.span.to }
                waitFor { viewer.notes.state.log == log }
                runOnUiThread { viewer.view.press(KeyAction.MARK) }
                waitFor { NotesFile.read(log).notes.map { it.text } == listOf("Mark 1") }

                val (begin, here) = viewer.current.recording!!.span.run { from to to }
                runOnUiThread { viewer.view.send(PlaceAction.GoTo((begin + here) / 2)) }
                waitFor { !viewer.live.isStaying }
                waitFor { viewer.current.recording!!.span.to > here + 0.5 }
                viewer.view.cursors.pinned shouldBe (begin + here) / 2
                // A mark is made at the newest moment, wherever the person looks.
                runOnUiThread { viewer.view.press(KeyAction.MARK) }
                waitFor { NotesFile.read(log).notes.any { it.text == "Mark 2" && it.x > here } }
                onNodeWithContentDescription("Follow the log while it is written (End)").performClick()
                viewer.live.isStaying shouldBe true

                onNodeWithText("Stop recording").performClick()
                waitForNotice(viewer, "${log.name} is recorded: ")
                await("Stop recording", isShown = false)
                waitFor { !viewer.live.isGrowing }
                folder.listDirectoryEntries("*.wpilog") shouldBe listOf(log)
            }
        }
    }

    test("recording a log for each time enabled does not replace the log that a person looks at") {
        val folder = tempdir().toPath()
        robot().use { server ->
            server.open()
            server.seek(0.0)
            beside(server, folder) { viewer ->
                record("Record a log each time the robot is enabled")
                waitFor { "Connected to the robot" in viewer.recording.state.connection }
                viewer.loader.open(samples.resolve("practice.bag"))
                waitFor { viewer.current.recording != null }
                await("A log begins when the robot is enabled.")
                folder.listDirectoryEntries("*.wpilog").shouldBeEmpty()
                server.start()
                waitForNotice(viewer, "is being recorded.")
                viewer.current.recording!!.file.name shouldBe "practice.bag"
                viewer.notices.all.single { it.action != null }.action!!.run()
                waitFor { viewer.current.recording!!.file.name.startsWith("FRC_") }
                viewer.live.isStaying shouldBe true
            }
        }
    }

    test("the graphs arranged for a folder appear as soon as the recorded log has their topics, and stay arranged") {
        val folder = tempdir().toPath()
        robot().use { server ->
            server.start()
            beside(server, folder) { viewer ->
                viewer.scope.launch { viewer.layouts.autosave() }
                viewer.loader.open(samples.resolve("qualification-42.bag").copyTo(folder.resolve("before.bag")))
                waitFor { viewer.current.recording != null }
                record("Record until stopped")
                waitFor { viewer.current.recording!!.signals.any { "Battery" in it.name && it.name.startsWith("NT:") } }
                val topics = listOf(viewer.current.recording!!.signals.first { "Battery" in it.name && it.name.startsWith("NT:") }.name)
                runOnUiThread { viewer.board.change { Board().withGraph(topics) } }
                onNodeWithText("Stop recording").performClick()
                waitFor { !viewer.recording.state.isOn }
                record("Record until stopped")
                val first = viewer.current.recording!!.file
                waitFor { viewer.current.recording!!.file != first }
                waitFor { viewer.board.state.graphs.singleOrNull()?.lines == topics }
            }
        }
    }

    test("a folder that cannot be written is reported, and ends the recording") {
        val file = tempdir().toPath().resolve("a-file").also { Files.writeString(it, "x") }
        robot().use { server ->
            server.start()
            beside(server, folder = file.parent) { viewer ->
                val elsewhere = RobotRecording(viewer.scope, viewer.notices, { file }, { listOf(RobotAddress("127.0.0.1", emptyList(), networkTablesPort = server.port)) }, RecordedLog(viewer.current, viewer.live, viewer.loader, viewer.notices) { false })
                runOnUiThread { elsewhere.start("1014", isPerEnable = false) }
                waitForNotice(viewer, "The log cannot be written")
                elsewhere.state.isOn shouldBe false
                viewer.notices.all.last().text shouldContain "check the disk and the folder"
            }
        }
    }
})
