package badlog.window.screen

import badlog.viewer.state.PlaceAction
import badlog.window.video.CountedVideo
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Path

@Tags("InCheck")
class VideoWindowSpec : FunSpec({
    test("a dropped video is shown beside the graphs, and keys step through its frames with the cursor").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val video = CountedVideo.write(tempdir().toPath().resolve("match.mp4"))
        RealWindow(tempdir().toPath(), Path.of("../samples/qualification-42.bag")).use { window ->
            window.awaitState("the log") { it.current.recording != null }
            window.awaitGraphs()
            window.look { it.openDropped(listOf(video)) }
            window.click("The robot is enabled in this frame")
            window.awaitState("the alignment") { it.video.state.alignment?.startSeconds == 2.0183 }
            window.press(KeyEvent.VK_PERIOD)
            window.awaitState("the next frame") { viewer -> viewer.video.state.frame?.let { CountedVideo.numberIn(it.image) } == 1 }
            window.look { Math.round((it.view.cursor ?: 0.0) * 1000) } shouldBe 2052L
            window.look { it.view.send(PlaceAction.GoTo(9.5)) }
            window.awaitState("the frame of the cursor") { viewer ->
                viewer.video.state.frame?.let { CountedVideo.numberIn(it.image) } == 224
            }
            window.picture("video", guide = "viewer-video")
        }
    }
})
