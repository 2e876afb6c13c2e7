package badlog.window.video

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.viewer.state.PlaceAction
import badlog.window.TestInspector
import badlog.window.app.Viewer
import badlog.window.files.ChosenFiles
import badlog.window.log.OpenRecording
import badlog.window.sidebar.InspectorTab
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import badlog.window.waiting.waitForNotice
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import java.nio.file.Files
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class VideoPanelSpec : FunSpec({
    val home = tempdir().toPath()
    val video = CountedVideo.write(home.resolve("match.mp4"))
    val log = home.resolve("q42.bag")
    // Enabled from 12 s on; the video begins at 10 s.
    val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Robot Enabled","unit":"ul","attrs":[]}],"values":[]}"""
    Files.writeString(log, "$header\nTime,Robot Enabled\n" + (0..400).joinToString("") { "${it / 10.0},${if (it in 120..300) 1 else 0}\n" })

    fun inWindow(file: Path?, test: ComposeUiTest.(Viewer) -> Unit) = runDesktopComposeUiTest(400, 700) {
        val scope = MainScope()
        val viewer = Viewer(scope, UserFolders(home, home), files = ChosenFiles(file))
        viewer.show(OpenRecording.read(log))
        viewer.panels.change { copy(inspector = InspectorTab.VIDEO) }
        setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
        scope.launch { viewer.video.run() }
        test(viewer)
        runOnIdle { viewer.video.close() }
        scope.cancel()
    }

    fun ComposeUiTest.open(viewer: Viewer) {
        onNodeWithContentDescription("Open a video").performClick()
        waitFor { viewer.video.state.frame != null }
    }

    // On the window’s thread, which frees the picture when it shows another one.
    fun ComposeUiTest.shown(viewer: Viewer) = runOnUiThread { viewer.video.state.frame?.let { CountedVideo.numberIn(it.image) } }

    test("after “Enabled here”, the cursor moves the video, and a step of the video moves the cursor") {
        inWindow(video) { viewer ->
            open(viewer)
            runOnIdle { viewer.video.seek(2.0) }
            waitFor { shown(viewer) == 60 }
            runOnIdle { viewer.view.cursor shouldBe null }
            onNodeWithContentDescription("The robot is enabled in this frame").performClick()
            runOnIdle {
                viewer.video.state.alignment?.startSeconds shouldBe 10.0
                viewer.view.cursor shouldBe 12.0
            }
            for (number in listOf(299, 0, 75)) {
                runOnIdle { viewer.view.send(PlaceAction.MoveCursor(10 + (number + 0.5) / CountedVideo.FRAMES_PER_SECOND)) }
                waitFor { shown(viewer) == number }
            }
            onNodeWithContentDescription("Next frame (.)").performClick()
            waitFor { shown(viewer) == 76 }
            onNodeWithContentDescription("Previous frame (,)").performClick()
            onNodeWithContentDescription("Previous frame (,)").performClick()
            waitFor { shown(viewer) == 74 }
            runOnIdle { Math.round(viewer.view.cursor!! * 1000) shouldBe 12_467 }
        }
    }

    test("a video reopens with its log at its place, unless it was closed") {
        inWindow(video) { viewer ->
            open(viewer)
            runOnIdle { viewer.video.alignEnabled() }
            val note = viewer.settings.state.videos.values.single()
            note shouldBe "12.0 $video"
            viewer.current.change { null }
            waitFor { viewer.video.state.file == null }
            viewer.show(OpenRecording.read(log))
            waitFor { viewer.video.state.frame != null }
            viewer.video.state.alignment?.startSeconds shouldBe 12.0
            onNodeWithContentDescription("Close the video").performClick()
            runOnIdle { viewer.settings.state.videos shouldBe emptyMap() }
            onNodeWithText("No video").assertExists()
        }
    }

    test("a file that is not a video is reported in the panel, and a log without a time accepts no video") {
        val broken = Files.writeString(home.resolve("broken.mp4"), "no video")
        inWindow(broken) { viewer ->
            onNodeWithContentDescription("Open a video").performClick()
            waitFor {
                onAllNodesWithText("broken.mp4 cannot be shown: it is not a video, or it is damaged.").fetchSemanticsNodes().isNotEmpty()
            }
            val rows = Files.writeString(home.resolve("rows.csv"), "A,B\n1,2\n3,4\n")
            viewer.show(OpenRecording.read(rows))
            onNodeWithText("The x axis of this log is not a time, so no video can be shown beside it.").assertExists()
            viewer.video.open(video)
            waitForNotice(viewer, "is not a time")
        }
    }
})
