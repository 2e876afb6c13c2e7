package badlog.window.graph.mark

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FindingLabelSpec : FunSpec({
    test("the label of a finding is beside its time, not over it") {
        besides(from = 100, to = 140, width = 300, room = 1000, gap = 8) shouldBe 148
        besides(from = 800, to = 840, width = 300, room = 1000, gap = 8) shouldBe 492
    }

    test("if neither side has room, the label is on the wider one, within the graph") {
        besides(from = 100, to = 900, width = 300, room = 1000, gap = 8) shouldBe 0
        besides(from = 100, to = 200, width = 950, room = 1000, gap = 8) shouldBe 50
        besides(from = 10, to = 20, width = 500, room = 300, gap = 8) shouldBe 0
    }

    test("the label becomes narrower before it covers the finding's time") {
        fun width(from: Int, to: Int) = widthBeside(from, to, room = 600, gap = 8, least = 150, most = 340)
        width(from = 100, to = 140) shouldBe 340
        width(from = 240, to = 420) shouldBe 232
        width(from = 120, to = 500) shouldBe 340
        width(from = -50, to = -20) shouldBe 340
    }
})
