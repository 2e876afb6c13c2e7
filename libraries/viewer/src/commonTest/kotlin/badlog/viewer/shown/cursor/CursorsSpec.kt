package badlog.viewer.shown.cursor

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll

class CursorsSpec : FunSpec({
    test("the pointer does not move a pinned cursor, and is read only without one") {
        val free = Cursors().hovering(3.0)
        free.x shouldBe 3.0
        val pinned = free.clicked(3.0, 0.1).hovering(8.0)
        pinned.x shouldBe 3.0
        pinned.pointed shouldBe 8.0
        pinned.left().pointed shouldBe 3.0
        free.left().x shouldBe 3.0
    }

    test("a click on the pinned cursor unpins it, and a click beside it moves it and keeps the second") {
        val both = Cursors().clicked(3.0, 0.5).shiftClicked(5.0, 0.5)
        both.clicked(4.0, 0.5) shouldBe Cursors(pinned = 4.0, second = 5.0)
        both.clicked(3.4, 0.5) shouldBe Cursors(hover = 3.4)
    }

    test("a click with Shift sets the second cursor, removes it when on it, and without a first cursor sets the first") {
        Cursors().shiftClicked(3.0, 0.5) shouldBe Cursors(pinned = 3.0)
        val both = Cursors(pinned = 3.0).shiftClicked(1.0, 0.5)
        both.between shouldBe Span(1.0, 3.0)
        both.shiftClicked(1.2, 0.5) shouldBe Cursors(pinned = 3.0)
        Cursors(pinned = 3.0, second = 3.0).between shouldBe null
    }

    test("keys move the cursor, or the second one, which begins at the first") {
        Cursors().moved(7.0) { it + 1 } shouldBe Cursors(pinned = 7.0)
        val moved = Cursors(hover = 2.0).moved(7.0) { it + 1 }
        moved.pinned shouldBe 3.0
        val both = moved.withSecond().moved(7.0) { it + 1 }
        both.between shouldBe Span(3.0, 4.0)
        both.withSecond().second shouldBe null
        Cursors().withSecond() shouldBe Cursors()
    }

    test("Escape removes the second cursor, then the pin, then the cursor") {
        val all = Cursors(pinned = 1.0, second = 2.0, hover = 3.0)
        generateSequence(all) { it.cancelled() }.take(4).map { it.x to it.second }.toList() shouldBe
            listOf(1.0 to 2.0, 1.0 to null, 3.0 to null, null to null)
    }

    test("after any actions, there is no second cursor without a first, and hovering changes neither") {
        checkAll(Arb.list(Arb.int(0..6), 0..12), Arb.list(Arb.numericDouble(-10.0, 10.0), 12..12)) { steps, places ->
            var cursors = Cursors()
            steps.forEachIndexed { i, step ->
                val x = places[i]
                cursors = when (step) {
                    0 -> cursors.hovering(x).also { it.pinned to it.second shouldBe (cursors.pinned to cursors.second) }
                    1 -> cursors.left().also { it.x shouldBe cursors.x }
                    2 -> cursors.clicked(x, 1.0)
                    3 -> cursors.shiftClicked(x, 1.0)
                    4 -> cursors.withSecond()
                    5 -> cursors.moved(0.0) { it + x }
                    else -> cursors.cancelled()
                }
                if (cursors.second != null) cursors.isPinned shouldBe true
                cursors.between?.let { (it.from < it.to) shouldBe true }
            }
        }
    }
})
