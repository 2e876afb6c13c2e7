package badlog.viewer.choices.comparison

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class LogOffsetsSpec : FunSpec({
    val places = Arb.numericDouble(-1e4, 1e4)
    val moments = mapOf("open" to LogMoments(2.0, 5.0), "other" to LogMoments(10.0, 20.0), "third" to LogMoments(1.0, null))

    fun LogOffsets<String>.offset(log: String, open: String = "open") = of(log, open, moments)

    test("the aligned moment of every log is at its place in the open one") {
        checkAll(places, places) { from, otherFrom ->
            val both = mapOf(1 to LogMoments(from, from + 3), 2 to LogMoments(otherFrom, otherFrom + 7))
            otherFrom + LogOffsets<Int>(Alignment.START).of(2, 1, both) shouldBe (from plusOrMinus 1e-6)
            otherFrom + 7 + LogOffsets<Int>(Alignment.ENABLED).of(2, 1, both) shouldBe (from + 3 plusOrMinus 1e-6)
        }
    }

    test("a log that does not show when it was enabled starts with the others") {
        LogOffsets<String>(Alignment.ENABLED).offset("third") shouldBe 4.0
        LogOffsets<String>(Alignment.START).of("unread", "open", moments) shouldBe 2.0
    }

    test("without alignment, nothing moves, and the open log never does") {
        LogOffsets<String>(Alignment.NONE).offset("other") shouldBe 0.0
        for (alignment in Alignment.entries) LogOffsets<String>().alignedBy(alignment, "open", moments).offset("open") shouldBe 0.0
    }

    test("manual alignment begins with the current offsets") {
        for (alignment in Alignment.entries) {
            val before = LogOffsets<String>().alignedBy(alignment, "open", moments)
            val after = before.alignedBy(Alignment.MANUAL, "open", moments)
            after.alignment shouldBe Alignment.MANUAL
            for (log in moments.keys) after.offset(log) shouldBe before.offset(log)
        }
    }

    test("a log is at its moved place, and two logs keep their difference whichever is open") {
        checkAll(places, places) { first, second ->
            val moved = LogOffsets<String>().moved("other", first, "open", moments).moved("other", second, "open", moments)
            moved.offset("other") shouldBe (second plusOrMinus 1e-6)
            moved.offset("open", open = "other") shouldBe (-second plusOrMinus 1e-6)
        }
        LogOffsets<String>().moved("other", Double.NaN, "open", moments) shouldBe LogOffsets()
        LogOffsets<String>().moved("open", 3.0, "open", moments) shouldBe LogOffsets()
    }

    test("an offset is typed with a point or a comma, and shown without rounding errors") {
        offsetOf(" -1,25 ") shouldBe -1.25
        offsetOf("fast") shouldBe null
        offsetOf("Infinity") shouldBe null
        offsetText(0.1 + 0.2) shouldBe "0.3"
    }

    test("steps go to the left and to the right, without rounding errors") {
        OFFSET_STEPS.map { it.label } shouldContainExactly listOf("-1", "-.1", "-.02", "+.02", "+.1", "+1")
        OFFSET_STEPS.map { it.hintFor("Q42") }.drop(4) shouldContainExactly listOf("Move Q42 by +0.1", "Move Q42 by +1")
        val moved = LogOffsets<String>(Alignment.NONE).moved("other", 0.1 + 0.2, "open", moments)
        moved.offset("other") shouldBe 0.3
    }
})
