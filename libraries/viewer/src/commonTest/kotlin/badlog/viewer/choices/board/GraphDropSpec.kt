package badlog.viewer.choices.board

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class GraphDropSpec : FunSpec({
    val board = Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))

    fun Board.lines() = graphs.map { it.lines.joinToString("+") }

    test("a graph is dropped above another near its top, below it near its bottom, and into it between") {
        board.dropped(3, onto = 1, share = 0.1).lines() shouldBe listOf("C", "A", "B")
        board.dropped(3, onto = 1, share = 0.9).lines() shouldBe listOf("A", "C", "B")
        board.dropped(3, onto = 1, share = 0.5).lines() shouldBe listOf("A+C", "B")
        board.dropped(1, onto = 3, share = 0.9).lines() shouldBe listOf("B", "C", "A")
        board.dropped(1, onto = 3, share = 0.1).lines() shouldBe listOf("B", "A", "C")
    }

    test("a graph that is dropped on itself, or where it is, changes nothing") {
        for (share in listOf(0.0, 0.5, 1.0)) board.dropped(2, onto = 2, share = share) shouldBe board
        board.dropped(2, onto = 1, share = 0.9) shouldBe board
        board.dropped(2, onto = 3, share = 0.1) shouldBe board
    }

    test("a graph that no longer exists, or has no drop target, changes nothing") {
        board.dropped(7, onto = 1, share = 0.5) shouldBe board
        board.dropped(7, onto = 1, share = 0.9) shouldBe board
        board.dropped(1, onto = 7, share = 0.5) shouldBe board
    }
})
