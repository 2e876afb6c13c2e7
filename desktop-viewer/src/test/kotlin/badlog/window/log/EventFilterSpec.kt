package badlog.window.log

import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class EventFilterSpec : FunSpec({
    val open = recordingOf(
        bagOf(listOf("Time|xaxis", "Arm/Log|log", "Drive/Log|log"), listOf("2,homed,", "1,,stopped", "3,jammed,Started", ",lost,", "5,,")),
    )

    test("a filter for topics of another log accepts all events") {
        fun count(filter: EventFilter) = filter.over(open.events, open.eventLogs).size
        count(EventFilter(topics = setOf("Drive/Log"))) shouldBe 2
        count(EventFilter(topics = setOf("Of another robot"))) shouldBe 5
        count(EventFilter("jam", setOf("Drive/Log"))) shouldBe 0
    }
})
