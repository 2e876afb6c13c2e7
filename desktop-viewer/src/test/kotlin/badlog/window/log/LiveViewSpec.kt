package badlog.window.log

import badlog.viewer.state.PlaceAction
import badlog.window.bagOf
import badlog.window.graph.viewerOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LiveViewSpec : FunSpec({
    fun log(seconds: Int) = recordingOf(bagOf(listOf("Time|xaxis", "A/Voltage"), List(seconds * 10 + 1) { "${it / 10.0},$it" }))

    fun growing() = viewerOf(log(10)).apply {
        live.grows(current.recording?.file)
        view.send(PlaceAction.Show(5.0, 10.0))
        live.begin()
    }

    test("following a log shows its newest moment at the visible width, and ends at the previous place") {
        val viewer = growing()
        for (seconds in 11..20) viewer.shown.show(log(seconds))
        viewer.live.isStaying shouldBe true
        viewer.view.cursors.pinned shouldBe 20.0
        (viewer.view.viewport.visible.from to viewer.view.viewport.visible.to) shouldBe (15.0 to 20.0)
        viewer.live.newest shouldBe 20.0
    }

    test("after following a log, its growth does not move the visible range, even if that ended at its end") {
        val viewer = growing()
        viewer.live.pause()
        for (seconds in 11..20) viewer.shown.show(log(seconds))
        viewer.live.isStaying shouldBe false
        (viewer.view.viewport.visible.from to viewer.view.viewport.visible.to) shouldBe (5.0 to 10.0)
        viewer.view.cursors.pinned shouldBe 10.0
        viewer.live.newest shouldBe 20.0
    }

    test("a log that no longer grows has no newest moment") {
        val viewer = growing()
        viewer.live.grows(null)
        viewer.live.newest shouldBe null
        viewer.live.isGrowing shouldBe false
    }
})
