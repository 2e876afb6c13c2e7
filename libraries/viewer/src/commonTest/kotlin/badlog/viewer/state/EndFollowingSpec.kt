package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class EndFollowingSpec : FunSpec({
    val end = Place(Viewport(Span(0.0, 10.0)).showing(5.0, 10.0)).atEnd()
    val following = EndFollowing().begun(end)

    /** [place] when the log has grown to [to], before any move. */
    fun grown(place: Place, to: Double) = place.copy(range = place.range.grown(Span(0.0, to)))

    test("hovering and zooming with the end in sight stay at the end, and the next growth moves there with the same zoom") {
        val hovered = end.copy(cursors = end.cursors.hovering(7.0), range = end.range.scaled(0.5, 10.0))
        following.isAt(hovered) shouldBe true
        following.isUntouched(hovered) shouldBe false
        val next = following.grown(hovered, grown(hovered, 12.0))
        next.place.range.visible shouldBe Span(9.5, 12.0)
        next.place.cursors.pinned shouldBe 12.0
        next.following.isAt(next.place) shouldBe true
    }

    test("panning and zooming away, and moving or adding a cursor, leave the end, and the log grows without the person") {
        val places = listOf(
            end.copy(range = end.range.panned(-0.25)),
            end.copy(range = end.range.showing(1.0, 3.0)),
            end.copy(cursors = end.cursors.clicked(6.0, 0.0)),
            end.copy(cursors = end.cursors.shiftClicked(6.0, 0.0)),
            end.at(4.0),
            end.cancelled(),
        )
        for (place in places) {
            following.isAt(place) shouldBe false
            val next = following.grown(place, grown(place, 12.0))
            next.following shouldBe EndFollowing()
            next.place.cursors shouldBe place.cursors
        }
    }

    test("pausing keeps the range, though it ended where the log did, until another one is shown") {
        val paused = following.paused(end)
        paused.isAt(end) shouldBe false
        val next = paused.grown(end, grown(end, 12.0))
        next.place.range.visible shouldBe Span(5.0, 10.0)
        next.following.grown(next.place, grown(next.place, 14.0)).place.range.visible shouldBe Span(5.0, 10.0)
        val elsewhere = next.place.copy(range = next.place.range.showing(7.0, 12.0))
        next.following.grown(elsewhere, grown(elsewhere, 14.0)).place.range.visible shouldBe Span(9.0, 14.0)
    }

    test("a log that begins elsewhere after it has grown is another one, and its range is not kept") {
        val paused = following.paused(end)
        val other = Place(Viewport(Span(100.0, 120.0)))
        paused.grown(end, other).run {
            place shouldBe other
            this.following shouldBe EndFollowing()
        }
    }

    test("a person who did not ask to stay, or was not shown the growth, is not at the end") {
        EndFollowing().isAt(end) shouldBe false
        following.isAt(grown(end, 12.0)) shouldBe false
    }
})
