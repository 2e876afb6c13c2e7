package badlog.window.video

import androidx.compose.runtime.snapshots.Snapshot
import badlog.files.UserFolders
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.files.ChosenFiles
import badlog.window.graph.bagOf
import badlog.window.graph.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.cancel
import kotlinx.coroutines.launch
import org.jetbrains.skia.Bitmap

class LogVideoSpec : FunSpec({
    fun frame(seconds: Double, leads: Boolean) = ReadFrame(VideoFrame(seconds, Bitmap().apply { allocN32Pixels(2, 2) }), 60.0, leads)

    test("a cursor moved while a step is being read stays there, and the video follows it") {
        val home = tempdir().toPath()
        val scope = CoroutineScope(Dispatchers.Unconfined + Job())
        val asked = ArrayList<String>()
        var answer: (ReadFrame) -> Unit = {}
        val source = object : FrameSource {
            override fun seek(seconds: Double, leads: Boolean) {
                asked += "second $seconds"
            }

            override fun step(count: Int) {
                asked += "$count further"
            }

            override fun close() = Unit
        }
        val viewer = Viewer(scope, UserFolders(home, home)).apply { current.replace(recordingOf(bagOf(401) { 0.0 })) }
        val video = with(viewer) {
            LogVideo(scope, current, view, player, settings, ChosenFiles(null), notices) { _, onFrame, _ ->
                answer = onFrame
                source
            }
        }
        viewer.view.send(PlaceAction.Open(checkNotNull(viewer.current.recording).span))
        scope.launch { video.run() }
        video.open(home.resolve("match.mp4"))
        answer(frame(0.0, leads = false))
        viewer.view.send(PlaceAction.MoveCursor(10.0))
        video.toggleLink()
        Snapshot.sendApplyNotifications()
        video.step(1)
        viewer.view.send(PlaceAction.MoveCursor(20.0))
        answer(frame(1 / 30.0, leads = true))
        viewer.view.cursor shouldBe 20.0
        Snapshot.sendApplyNotifications()
        answer(frame(10.0, leads = false))
        asked shouldContainExactly listOf("1 further", "second 10.0")
        viewer.view.cursor shouldBe 20.0
        video.state.frame?.time shouldBe 10.0
        // A later step leads again, and so does a second step that was requested before the first one was read.
        video.step(1)
        video.step(1)
        answer(frame(10.0 + 1 / 30.0, leads = true))
        answer(frame(10.0 + 2 / 30.0, leads = true))
        Math.round(checkNotNull(viewer.view.cursor) * 1000) shouldBe 20_067
        scope.cancel()
    }
})
