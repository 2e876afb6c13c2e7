package badlog.season.lake

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class LakeTableSpec : FunSpec({
    fun event(t: Any?, text: String = "text") = LakeTable.EVENTS.record("log" to "1.bag", "topic" to "Log", "t" to t, "timestamp" to null, text to "go")

    test("a record has the values of its fields, in the order of the table") {
        List(5) { event(0.5)[it] } shouldBe listOf("1.bag", "Log", 0.5, null, "go")
    }

    test("a record with an unknown field or a value of another type is refused") {
        shouldThrow<IllegalArgumentException> { event(0.5, text = "message") }.message shouldContain "not log, topic, t, timestamp, message"
        shouldThrow<IllegalArgumentException> { event("0.5") }.message shouldContain "The field t of events cannot hold 0.5"
    }
})
