package badlog.viewer.session

import badlog.core.analysis.Span
import badlog.signals.pose.posesOf
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.draw.path.poseTopics
import badlog.viewer.state.after
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class GraphOffersSpec : FunSpec({
    val board = Board().withGraph(listOf("A")).withGraph(listOf("B", "C")).withGraph(listOf("D"))

    fun offers(place: Int, of: Board = board) = GraphOffers(of, of.graphs[place], emptyList())

    fun List<GraphOffer>.labels() = map { it.label }

    fun Board.take(offer: GraphOffer) = after(offer.change)

    fun Board.lines() = graphs.map { it.lines.joinToString("+") }

    test("a graph is offered only moves to other places") {
        offers(0).moves.labels() shouldContainExactly listOf("Move down")
        offers(1).moves.labels() shouldContainExactly listOf("Move up", "Move down")
        offers(2).moves.labels() shouldContainExactly listOf("Move to the top", "Move up")
        board.take(offers(2).moves[0]).lines() shouldContainExactly listOf("D", "A", "B+C")
    }

    test("the current height is marked, also the usual one of a graph without its own") {
        fun marked(of: Board, usual: GraphHeight?) = offers(0, of).heights(usual).filter { it.isOn == true }.labels()
        marked(board, null).shouldBeEmpty()
        marked(board, GraphHeight.MEDIUM) shouldContainExactly listOf("Height: medium")
        marked(board.resized(1, GraphHeight.LARGE.pixels), GraphHeight.MEDIUM) shouldContainExactly listOf("Height: large")
    }

    test("fixed limits on either axis are marked, and released on both") {
        val limits = listOf(Span(0.0, 1.0), Span(2.0, 3.0))
        val fixed = board.take(offers(1).limits(limits)[0])
        fixed.graphs[1].run { listOf(yRange, rightYRange) } shouldContainExactly limits
        for (one in listOf(fixed, board.withYRange(2, null, limits[1]))) {
            val offer = offers(1, one).limits(limits)[0]
            offer.isOn shouldBe true
            one.take(offer) shouldBe board
        }
        offers(1, board.withXy(2, true)).limits(limits).shouldBeEmpty()
    }

    test("only several lines can be drawn over each other, or each in its own graph") {
        offers(0).planes.shouldBeEmpty()
        offers(0).separation shouldBe null
        val xy = board.take(offers(1).planes.single())
        offers(1, xy).planes.labels() shouldContainExactly listOf("XY plot over the first line", "Swap axes")
        offers(1).separation?.let { board.take(it).lines() } shouldBe listOf("A", "B", "C", "D")
    }

    test("only paths have an origin") {
        val poses = posesOf(poseTopics("Drive/Pose"))
        val path = Board().withGraph(listOf(poses[0].x, poses[0].y)).withXy(1, true)
        GraphOffers(path, path.graphs[0], poses).origins.filter { it.isOn == true }.labels() shouldContainExactly listOf("Blue origin")
        GraphOffers(path, path.graphs[0], emptyList()).origins.shouldBeEmpty()
    }

    test("a graph is added to any other one, under that one's title, or removed") {
        val additions = offers(0).additions(listOf("a", "b", "d"))
        additions.labels() shouldContainExactly listOf("Add to “b”", "Add to “d”")
        board.take(additions[1]).lines() shouldContainExactly listOf("B+C", "D+A")
        board.take(offers(0).removal).lines() shouldContainExactly listOf("B+C", "D")
    }
})
