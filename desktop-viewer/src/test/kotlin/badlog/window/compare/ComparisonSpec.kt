package badlog.window.compare

import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.LogOffsets
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class ComparisonSpec : FunSpec({
    fun recording(name: String, from: Double, enabledAt: Double) = recordingOf(
        """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Enabled","unit":"ul","attrs":[]}],"values":[]}""" +
            "\nTime,Enabled\n$from,0\n$enabledAt,1\n${enabledAt + 100},1\n",
        name,
    )

    val open = recording("open.bag", 2.0, 5.0)
    val other = recording("other.bag", 10.0, 20.0)
    val third = recordingOf("Time,A\n", "empty.bag")
    val both = Comparison().with(other.file).with(third.file).withLoaded(other).withLoaded(third)

    test("recordings are aligned by their beginning or by when the robot was enabled, and can be moved by hand") {
        both.offsetOf(other, open) shouldBe -8.0
        both.offsetOf(third, open) shouldBe 2.0
        val enabled = both.alignedBy(Alignment.ENABLED, open)
        enabled.offsetOf(other, open) shouldBe -15.0
        val moved = enabled.movedTo(third.file, 1.5, open)
        moved.offsetOf(other, open) shouldBe -15.0
        moved.offsetOf(third, open) shouldBe 1.5
    }

    test("an unchecked recording is released, and a recording that is not checked is not kept") {
        both.without(other.file).loaded.keys shouldBe setOf(third.file)
        Comparison().withLoaded(other) shouldBe Comparison()
        both.with(other.file) shouldBe both
        both.alignedBy(Alignment.ENABLED, open).cleared() shouldBe Comparison(offsets = LogOffsets(Alignment.ENABLED))
    }
})
