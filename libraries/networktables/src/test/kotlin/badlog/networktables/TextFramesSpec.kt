package badlog.networktables

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class TextFramesSpec : FunSpec({
    test("a long list of messages is read completely") {
        messagesIn("[]").size shouldBe 0
        messagesIn(List(10_000) { """{"method":"a[{[{"}""" }.joinToString(",", "[", "]")).size shouldBe 10_000
    }

    test("an error describes a frame that is not a list of messages") {
        fun problemIn(text: String) = shouldThrow<UnreadableFrameException> { messagesIn(text) }.what
        problemIn("{") shouldBe "not JSON"
        problemIn("{}") shouldBe "not a list of messages"
        problemIn("[".repeat(1_000_000)) shouldBe "JSON that is nested too deeply"
        problemIn("[\"\\\"" + "{".repeat(200)) shouldBe "not JSON"
    }

    test("any text is read or throws UnreadableFrameException") {
        checkAll(Arb.string(0..200)) { text ->
            try {
                messagesIn("[$text")
            } catch (_: UnreadableFrameException) {
                // The expected outcome.
            }
        }
    }
})
