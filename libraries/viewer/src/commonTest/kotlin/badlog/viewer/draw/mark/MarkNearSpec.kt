package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.viewer.bagView
import badlog.viewer.choices.note.Note
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MarkNearSpec : FunSpec({
    val view = bagView(listOf("Time|xaxis", "Log|log"), listOf("10,homed", "20,jammed"))
    val events = EventTimeline.of(view.folders.flatMap { it.eventLogs })
    val notes = listOf(Note(20.1, "Look here."), Note(40.0, "And here."))

    fun said(x: Double, visible: Span) = markNear(x, visible, notes, events)?.let { it.x to it.text }

    test("a cursor points at the nearest note, otherwise at the nearest event, within a part of the screen") {
        val visible = Span(0.0, 100.0)
        said(10.5, visible) shouldBe (10.0 to "homed")
        said(20.0, visible) shouldBe (20.1 to "Look here.")
        said(39.5, visible) shouldBe (40.0 to "And here.")
        said(30.0, visible) shouldBe null
        said(Double.NaN, visible) shouldBe null
    }

    test("the reach of a cursor shrinks with the visible range") {
        said(10.5, Span(10.0, 20.0)) shouldBe null
        said(10.05, Span(10.0, 20.0)) shouldBe (10.0 to "homed")
    }
})
