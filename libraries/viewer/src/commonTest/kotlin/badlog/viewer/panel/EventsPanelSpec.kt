package badlog.viewer.panel

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.viewer.bagView
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.shown.search.Query
import badlog.viewer.state.PlaceAction
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class EventsPanelSpec : FunSpec({
    val view = bagView(listOf("Time|xaxis", "Log|log"), listOf("0,", "1,start", "2,", "3,brownout"))
    val events = EventTimeline.of(view.folders.flatMap { it.eventLogs })
    val times = LogTimes(3.0, view.xAxis, listOf(EnabledSpan(Span(1.0, 3.0), isAutonomous = false)))

    fun panel(found: EventTimeline, hasTopics: Boolean = false, nearest: Int = -1) = eventsPanel(found, events.size, times, hasTopics, nearest)
    fun List<Part>.rows() = filterIsInstance<Rows>().single().rows.map { it as Row }
    fun List<Part>.texts() = filterIsInstance<Paragraph>().map { it.text }

    test("events are listed in order, and a press moves the cursor there") {
        val rows = panel(events).rows()
        rows.map { it.lines.single().text } shouldContainExactly listOf("start", "brownout")
        rows.map { it.lines.single().time } shouldContainExactly listOf(1.0, 3.0).map(times::logged)
        rows[1].name shouldBe "Event at ${times.logged(3.0)}: brownout"
        rows[1].open.shouldBeInstanceOf<PlaceAction.GoTo>().run { x to isWithSurroundings } shouldBe (3.0 to false)
        rows.flatMap { it.below } shouldBe emptyList()
    }

    test("the event nearest to the cursor is the current one") {
        val rows = panel(events, nearest = 1).filterIsInstance<Rows>().single()
        rows.current shouldBe 1
        rows.rows.map { (it as Row).isCurrent } shouldContainExactly listOf(false, true)
    }

    test("events of several topics show theirs") {
        panel(events, hasTopics = true).rows().first().below.map { (it as Paragraph).text } shouldContainExactly listOf("Log")
    }

    test("the number of events is given, and the reason for none") {
        panel(events.matching(Query("brown"))).texts() shouldContainExactly listOf("1 of 2 events")
        panel(events.matching(Query("nothing"))).texts() shouldContainExactly listOf("0 of 2 events", "No event matches.")
        eventsPanel(EventTimeline.NONE, 0, times, hasTopics = false, nearest = -1).texts().single() shouldBe "This log has no events: no topic contains event texts."
    }

    test("among graphs, only the first events are listed, and each can be zoomed to") {
        val rows = eventRows("Log", events, times, limit = 1).rows.map { it as Row }
        rows.single().tools.single().action.shouldBeInstanceOf<PlaceAction.GoTo>().run { x to isWithSurroundings } shouldBe (1.0 to true)
    }
})
