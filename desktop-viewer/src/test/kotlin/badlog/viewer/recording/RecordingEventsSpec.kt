package badlog.viewer.recording

import badlog.viewer.bagOf
import badlog.viewer.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class RecordingEventsSpec : FunSpec({
    val open = recordingOf(
        bagOf(listOf("Time|xaxis", "Arm/Log|log", "Drive/Log|log"), listOf("2,homed,", "1,,stopped", "3,jammed,Started", ",lost,", "5,,")),
    )

    fun MatchingEvents.texts() = (0 until size).map { "${x[it]} ${textOf(it)}" }

    test("events of all topics stand in the order of x, those without one last") {
        open.events.all.texts() shouldContainExactly listOf("1.0 stopped", "2.0 homed", "3.0 jammed", "3.0 Started", "NaN lost")
        open.events.all.placedCount shouldBe 4
    }

    test("a filter finds words in text and topic, and keeps to its topics") {
        open.events.matching(EventFilter("START")).texts() shouldContainExactly listOf("3.0 Started")
        open.events.matching(EventFilter("arm jam")).texts() shouldContainExactly listOf("3.0 jammed")
        open.events.matching(EventFilter(topics = setOf("Drive/Log"))).texts() shouldContainExactly listOf("1.0 stopped", "3.0 Started")
        open.events.matching(EventFilter(topics = setOf("Of another robot"))).size shouldBe 5
        open.events.matching(EventFilter("nowhere")).size shouldBe 0
        open.events.matching(EventFilter(" ")) shouldBe open.events.all
    }

    test("the nearest event is found among those with an x") {
        open.events.all.nearest(2.4) shouldBe 1
        open.events.all.nearest(99.0) shouldBe 3
        MatchingEvents.NONE.nearest(1.0) shouldBe -1
    }

    test("places are put in order without losing which was first") {
        checkAll(Arb.list(Arb.double(), 0..40)) { places ->
            val order = orderOf(places.toDoubleArray())
            order.toList() shouldBe places.indices.sortedBy { places[it] }
        }
    }

    test("100,000 events are all there, and filtered") {
        val rows = List(100_000) { "${(it * 7919L) % 100_000},event ${it % 1000}" }
        val events = recordingOf(bagOf(listOf("Time|xaxis", "Log|log"), rows)).events
        events.all.size shouldBe 100_000
        events.all.x.toList().shouldBeSorted()
        events.matching(EventFilter("event 77")).size shouldBe 1900
    }
})
