package badlog.viewer.choices.board

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class GraphTitlesSpec : FunSpec({
    fun boardOf(vararg titles: String) = Board(titles.mapIndexed { i, title -> BoardGraph(i + 1, title, listOf("$title/$i")) })

    test("equal titles are numbered from the second on, without using an existing number") {
        boardOf("A/Speed", "Path", "A/Speed", "Path (2)", "Path").titles shouldContainExactly
            listOf("A/Speed", "Path", "A/Speed (2)", "Path (2)", "Path (3)")
    }

    test("a short title has as much of its path as distinguishes it, and equal ones are numbered") {
        boardOf("Drive/Left/Speed", "Arm/Angle", "Drive/Right/Speed", "Arm/Angle").shortTitles shouldContainExactly
            listOf("Left/Speed", "Angle", "Right/Speed", "Angle (2)")
    }

    test("a title that lists lines is not cut at a slash of one of them") {
        val board = boardOf("Drive: Left/Speed, Right/Speed", "Drive: Left/Angle, Right/Angle…", "Arm/Speed")
        board.shortTitles shouldContainExactly listOf("Drive: Left/Speed, Right/Speed", "Drive: Left/Angle, Right/Angle…", "Speed")
        Board().withGraph(listOf("Arm/a, b")).shortTitles shouldContainExactly listOf("a, b")
    }

    test("the title of a graph is the one on its board, or its own if it is not on one") {
        val board = boardOf("Path", "Path")
        board.titleOf(board.graphs[1]) shouldBe "Path (2)"
        Board().titleOf(board.graphs[1]) shouldBe "Path"
    }

    test("no two graphs of any board have the same title") {
        val parts = Arb.element("A", "B", "A/B", "B/A", "A/A/B", "A (2)", "A, B", "/A", "")
        checkAll(Arb.list(parts, 0..12)) { titles ->
            boardOf(*titles.toTypedArray()).run { listOf(this.titles, shortTitles) }.forEach { it.shouldBeUnique() }
        }
    }
})
