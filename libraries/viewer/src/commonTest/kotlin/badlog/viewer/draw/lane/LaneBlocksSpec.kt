package badlog.viewer.draw.lane

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class LaneBlocksSpec : FunSpec({
    val reused = LaneBlocks()

    fun blocks(count: Int, width: Double, state: (Int) -> Int): List<Triple<Double, Double, Int>> {
        val series = Series(DoubleArray(count) { it.toDouble() }, DoubleArray(count) { state(it).toDouble() })
        val end = count - 1.0
        reused.place(StateRuns(series, end), Span(0.0, end), width, density = 1.0)
        return List(reused.size) { Triple(reused.left[it], reused.right[it], reused.states[it]) }
    }

    test("long states are drawn with their true length") {
        blocks(101, 200.0) { if (it < 50) 0 else 1 } shouldBe listOf(Triple(0.0, 100.0, 0), Triple(100.0, 200.0, 1))
    }

    test("a state of one row among 10,000 gets two pixels, over its neighbors") {
        val blocks = blocks(10_001, 1000.0) { if (it == 6000) 1 else 0 }
        blocks.last() shouldBe Triple(600.0, 602.0, 1)
        blocks.count { it.third == 0 } shouldBe 2
    }

    test("a dropout of one row is also visible") {
        blocks(10_001, 1000.0) { if (it == 6000) 0 else 1 }.last() shouldBe Triple(600.0, 602.0, 0)
    }

    test("a last row that alone differs is visible") {
        blocks(10_001, 1000.0) { if (it == 10_000) 1 else 0 }.last() shouldBe Triple(998.0, 1000.0, 1)
    }

    test("the rarest of several states in one pixel is visible, whichever is first") {
        val rareLast = blocks(100_001, 1000.0) { if (it in 50_000..50_009) (if (it == 50_005) 2 else 1) else 0 }
        rareLast.last() shouldBe Triple(500.0, 502.0, 2)
        val rareFirst = blocks(100_001, 1000.0) { if (it in 50_000..50_009) (if (it == 50_000) 2 else 1) else 0 }
        rareFirst.last() shouldBe Triple(500.0, 502.0, 2)
    }

    test("millions of changes become at most as many blocks as there are pixels") {
        val blocks = blocks(100_000, 500.0) { it % 3 }
        (blocks.size <= 500) shouldBe true
        blocks.sumOf { it.second - it.first } shouldBe 500.0
    }

    test("no state is lost if each has room, and no block is outside the lane") {
        checkAll(Arb.list(Arb.int(0..3), 2..200), Arb.int(10..300)) { states, width ->
            val blocks = blocks(states.size, width.toDouble()) { states[it] }
            for (block in blocks) (block.first >= 0 && block.second <= width && block.first < block.second) shouldBe true
            if (states.size * 2 <= width) blocks.map { it.third }.toSet() shouldBe states.toSet()
        }
    }

    test("off is pale, a narrow block strong, and a wide one leaves its name readable") {
        LaneTone.of(listOf("false", "true"), 0, 1.0) shouldBe LaneTone.OFF
        LaneTone.of(listOf("false", "true"), 1, 1.0) shouldBe LaneTone.STRONG
        LaneTone.of(listOf("LOW", "HIGH"), 0, 30.0) shouldBe LaneTone.QUIET
    }
})
