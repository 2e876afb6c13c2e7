package badlog.viewer.choices.board

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class BoardHistorySpec : FunSpec({
    test("any changes are undone step by step, and redone") {
        checkAll(Arb.list(Arb.int(0..5), 0..40)) { deeds ->
            var history = BoardHistory()
            val boards = ArrayList<Board>().apply { add(history.now) }
            for (deed in deeds) {
                val next = if (deed == 0) history.now.without(1) else history.now.withOwnToggled("Topic $deed")
                history = history.changed(next)
                if (!next.showsSame(boards.last())) boards += next
            }
            for (board in boards.asReversed()) {
                history.now shouldBe board
                history = history.undone()
            }
            history.canUndo shouldBe false
            for (board in boards) {
                history.now shouldBe board
                history = history.redone()
            }
            history.canRedo shouldBe false
        }
    }

    test("a change that shows the same is not a step, and after a new step nothing can be redone") {
        val one = Board().withGraph(listOf("A"))
        val history = BoardHistory().changed(one)
        history.changed(one.copy(graphs = one.graphs.map { it.copy(id = 7) })) shouldBe history
        history.undone().changed(Board().withGraph(listOf("B"))).canRedo shouldBe false
    }

    test("the first of very many steps are forgotten") {
        var history = BoardHistory()
        for (i in 1..500) history = history.changed(Board().withGraph(listOf("Topic $i")))
        var steps = 0
        while (history.canUndo) {
            history = history.undone()
            steps++
        }
        (steps in 50..200) shouldBe true
    }

    test("renaming or removing a signal everywhere is not undone, and a step without another change disappears") {
        val one = Board().withGraph(listOf("A"))
        val history = BoardHistory(one).changed(one.withGraph(listOf("B"))).changed(one.withGraph(listOf("B")).withGraph(listOf("C")))
        val without = history.everywhere { withoutSignal("B") }
        without.now.graphs.map { it.title } shouldBe listOf("A", "C")
        without.undone().now shouldBe one
        without.undone().canUndo shouldBe false
        history.everywhere { withoutSignal("C") }.undone().now shouldBe one
        history.undone().undone().everywhere { renamed("B", "D") }.redone().now.graphs.map { it.title } shouldBe listOf("A", "D")
    }
})
