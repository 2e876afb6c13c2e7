package badlog.window.compare

import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class ComparisonSpec : FunSpec({
    fun recording(name: String, from: Double, enabledAt: Double) = recordingOf(
        """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Enabled","unit":"ul","attrs":[]}],"values":[]}""" +
            "\nTime,Enabled\n$from,0\n$enabledAt,1\n${enabledAt + 100},1\n",
        name,
    )

    val places = Arb.numericDouble(-1e4, 1e4)
    val open = recording("open.bag", 2.0, 5.0)
    val other = recording("other.bag", 10.0, 20.0)
    val third = recordingOf("Time,A\n1,1\n2,2\n", "third.bag")
    val both = Comparison().with(other.file).with(third.file).withLoaded(other).withLoaded(third)

    test("the aligned moment of every recording stands where it stands in the open one") {
        checkAll(places, places) { from, otherFrom ->
            val first = recording("a.bag", from, from + 3)
            val second = recording("b.bag", otherFrom, otherFrom + 7)
            for (alignment in listOf(Alignment.START, Alignment.ENABLED)) {
                val offset = Comparison(alignment = alignment).offsetOf(second, first)
                alignment.momentIn(second) + offset shouldBe (alignment.momentIn(first) plusOrMinus 1e-6)
            }
        }
    }

    test("a recording that does not show when it was enabled begins with the others") {
        Alignment.ENABLED.momentIn(open) shouldBe 5.0
        Alignment.ENABLED.momentIn(third) shouldBe 0.0
        Alignment.START.momentIn(recordingOf("Time,A\n", "empty.bag")) shouldBe 0.0
    }

    test("as logged, nothing moves; the open recording never does") {
        Comparison(alignment = Alignment.NONE).offsetOf(other, open) shouldBe 0.0
        for (alignment in Alignment.entries) both.alignedBy(alignment, open).offsetOf(open, open) shouldBe 0.0
    }

    test("alignment by hand begins where everything stands") {
        for (alignment in Alignment.entries) {
            val before = both.alignedBy(alignment, open)
            val after = before.alignedBy(Alignment.MANUAL, open)
            after.alignment shouldBe Alignment.MANUAL
            after.offsetOf(other, open) shouldBe before.offsetOf(other, open)
        }
    }

    test("a recording stands where it is moved to, and the same two stand alike whichever is open") {
        checkAll(places, places) { first, second ->
            val moved = both.movedTo(other.file, first, open).movedTo(other.file, second, open)
            moved.offsetOf(other, open) shouldBe (second plusOrMinus 1e-6)
            moved.offsetOf(open, other) shouldBe (-second plusOrMinus 1e-6)
        }
        both.movedTo(other.file, Double.NaN, open) shouldBe both
        both.movedTo(open.file, 3.0, open) shouldBe both
    }

    test("unchecking lets go of what was read, and what is not checked is not kept") {
        both.without(other.file).loaded.keys shouldBe setOf(third.file)
        Comparison().withLoaded(other) shouldBe Comparison()
        both.with(other.file) shouldBe both
        both.alignedBy(Alignment.ENABLED, open).cleared() shouldBe Comparison(alignment = Alignment.ENABLED)
    }

    test("an offset is typed with a point or a comma, and shown without dust") {
        offsetOf(" -1,25 ") shouldBe -1.25
        offsetOf("fast") shouldBe null
        offsetOf("Infinity") shouldBe null
        rounded(0.1 + 0.2) shouldBe 0.3
    }
})
