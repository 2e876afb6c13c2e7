package badlog.window.folder

import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertCountEquals
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.bag
import badlog.catalog.folder.putSamples
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.sidebar.InspectorTab
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.time.Instant
import kotlin.io.path.div

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class NewLogsSpec : FunSpec({
    /** Opens a folder of samples without Qualification 42. [arrives] copies it into the folder, as if it had been written an hour ago. */
    fun onFolder(steps: DesktopComposeUiTest.(Viewer, arrives: () -> Unit) -> Unit) {
        val home = tempdir().toPath()
        val logs = tempdir().toPath().also { it.putSamples(areSettled = true) }
        val name = "qualification-42.bag"
        val match = Files.move(logs / name, home / name)
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        runDesktopComposeUiTest(1366, 768) {
            setContent { ViewerScreen(viewer) }
            viewer.scope.launch { viewer.newest.run() }
            viewer.scope.launch { viewer.newLogs.run() }
            viewer.library.open(logs)
            waitFor { viewer.newLogs.state.hasBegun && viewer.current.recording != null }
            try {
                steps(viewer) {
                    Files.setLastModifiedTime(match, FileTime.from(Instant.now().minusSeconds(3600)))
                    Files.move(match, logs / name)
                }
            } finally {
                viewer.library.close()
            }
        }
    }

    fun DesktopComposeUiTest.awaitBar(viewer: Viewer) {
        waitFor { viewer.newLogs.state.latest != null }
        onNodeWithText("Qualification 42 arrived: ", substring = true).assertExists()
        onNodeWithText("Browned out at 1:33.", substring = true).assertExists()
    }

    test("a log that arrives is announced, replaces no other log, and is shown at its worst finding; the first logs of a folder are not announced") {
        onFolder { viewer, arrives ->
            waitFor { viewer.library.state.entries.all { it.found != null || it.isGray } }
            onAllNodesWithContentDescription("New log").assertCountEquals(0)
            val before = viewer.current.recording
            arrives()
            awaitBar(viewer)
            viewer.current.recording shouldBe before
            onNodeWithContentDescription("Show the new log, at its worst finding (A)").performClick()
            waitFor { viewer.current.recording?.file?.fileName == Path.of("qualification-42.bag") }
            viewer.panels.state.inspector shouldBe InspectorTab.FINDINGS
            onAllNodesWithContentDescription("New log").assertCountEquals(0)
        }
    }

    test("a log rings once when it arrives if a person wants that, and not if it is open") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        var rings = 0
        val shown = HashSet<Path>()
        val logs = NewLogs(viewer.library, viewer.current, viewer.settings, { null }, { it in shown }) { rings++ }
        fun entry(name: String, size: Long, found: FindingSummary? = FindingSummary(0, emptyList())) = LogEntry(
            LogFile(Path.of("/logs/$name"), size, size),
            LogSummary(date = LogDate(0, DateSource.VALUES), content = Content.SOMETHING),
            found,
        )
        runDesktopComposeUiTest(100, 100) {
            setContent { LaunchedEffect(Unit) { logs.run() } }
            fun know(vararg entries: LogEntry) {
                viewer.library.change { copy(folder = Path.of("/logs"), hasLooked = true, files = files.ifEmpty { entries.map { it.source } }).withEntries(entries.toList()) }
                waitForIdle()
            }
            know(entry("a.bag", 1))
            know(entry("a.bag", 1), entry("b.bag", 1))
            rings shouldBe 0
            viewer.settings.change { copy(ringsForLogs = true) }
            know(entry("a.bag", 1), entry("b.bag", 1), entry("c.bag", 1))
            rings shouldBe 1
            know(entry("a.bag", 1), entry("b.bag", 1), entry("c.bag", 2, found = null))
            know(entry("a.bag", 1), entry("b.bag", 1), entry("c.bag", 3))
            know(entry("a.bag", 1))
            rings shouldBe 1
            logs.state.latest shouldBe null
        }
    }
})
