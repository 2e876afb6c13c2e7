package badlog.viewer.choices.board

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

/** The actions of several tabs or windows on one remembered board. */
class MergedBoardSpec : FunSpec({
    class Store(var board: Board) {
        var lastId = 1000
    }

    class Tab(private val store: Store) {
        private var history = BoardHistory(store.board) { ++store.lastId }
        private var known = store.board
        val board get() = history.now

        fun take(step: BoardHistory.() -> BoardHistory) {
            later(step)
            save()
        }

        fun change(step: Board.() -> Board) = take { changed(now.step()) }

        /** Writes after a pause, as a window does. */
        fun later(step: BoardHistory.() -> BoardHistory) {
            history = history.step()
        }

        fun save() {
            // Writes and reads the board, as a file does.
            store.board = boardOfJson(board.mergedWith(store.board, known).toJson(haveIds = true))
            known = board
        }
    }

    fun Board.named(title: String) = graphs.find { it.title == title }

    class Deed(val tab: Int, val kind: Int, val graph: Int, val value: Int)
    val deeds = Arb.list(arbitrary { Deed(Arb.int(0..2).bind(), Arb.int(0..5).bind(), Arb.int(0..6).bind(), Arb.int(60..600).bind()) }, 0..40)
    val start = Board().withGraph(listOf("A")).withGraph(listOf("B", "C")).withGraph(listOf("D"))

    test("after any actions of tabs, each change stays, and the later of two changes of one thing counts") {
        checkAll(deeds) { all ->
            val store = Store(start)
            val tabs = List(3) { Tab(store) }
            // The last written value of each part of each graph.
            val wanted = LinkedHashMap(start.graphs.associate { it.title to it.copy(id = 0) })
            all.forEachIndexed { i, deed ->
                val tab = tabs[deed.tab]
                val seen = tab.board.graphs.getOrNull(deed.graph)
                val title = seen?.title
                val before = title?.let(wanted::get)
                if (deed.kind == 0) {
                    tab.change { withGraph(listOf("New $i")) }
                    wanted["New $i"] = BoardGraph(0, "New $i", listOf("New $i"))
                }
                // This tab does not change a graph that another one has removed: that would bring it back.
                if (seen == null || title == null || before == null) return@forEachIndexed
                when (deed.kind) {
                    1 -> {
                        tab.change { without(seen.id) }
                        wanted -= title
                    }

                    2 -> {
                        tab.change { resized(seen.id, deed.value) }
                        // A board that shows the same is not a change.
                        if (seen.height != deed.value) wanted[title] = before.copy(height = deed.value)
                    }

                    3 -> {
                        tab.change { withLine(seen.id, "Line ${deed.value}") }
                        if ("Line ${deed.value}" !in seen.lines) wanted[title] = before.copy(lines = before.lines + "Line ${deed.value}")
                    }

                    4 -> {
                        tab.change { withYRange(seen.id, Span(0.0, deed.value.toDouble())) }
                        if (seen.yRange?.to != deed.value.toDouble()) wanted[title] = before.copy(yRange = Span(0.0, deed.value.toDouble()))
                    }

                    5 -> tab.change { moved(seen.id, deed.value % 3 - 1) }
                }
            }
            store.board.graphs.map { it.id }.shouldBeUnique()
            store.board.graphs.map { it.title }.toSet() shouldBe wanted.keys
            for ((title, graph) in wanted) {
                val stored = checkNotNull(store.board.named(title))
                stored.copy(id = 0, lines = emptyList()) shouldBe graph.copy(lines = emptyList())
                stored.lines.toSet() shouldBe graph.lines.toSet()
            }
        }
    }

    fun Board.idOf(title: String) = checkNotNull(named(title)).id

    /** A tab's change of the graph with a title, and whether that is on a board. */
    class Edit(val what: String, val done: Board.(String) -> Board, val isDone: Board.(String) -> Boolean)

    val edits = listOf(
        Edit("adds", { withGraph(listOf("New", it)) }, { graphs.count { graph -> graph.lines == listOf("New", it) } == 1 }),
        Edit("removes", { without(idOf(it)) }, { named(it) == null }),
        Edit("renames", { with(checkNotNull(named(it)).copy(title = "Own $it")) }, { graphs.count { graph -> graph.title == "Own $it" } == 1 }),
        Edit("moves", { movedBefore(idOf(it), null) }, { graphs.count { graph -> graph.title == it } == 1 }),
        Edit("resizes", { resized(idOf(it), 200) }, { named(it)?.height == 200 }),
        Edit("adds a line to", { withLine(idOf(it), "New") }, { named(it)?.lines == listOf(it, "New") }),
    )

    for (mine in edits) {
        test("a tab that ${mine.what} a graph keeps another tab's changes of other graphs, in any order") {
            for (theirs in edits) {
                for (isFirst in listOf(true, false)) {
                    val store = Store(Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C")))
                    val (a, b) = List(2) { Tab(store) }
                    a.later { changed(mine.done(now, "A")) }
                    b.later { changed(theirs.done(now, "B")) }
                    for (tab in if (isFirst) listOf(a, b) else listOf(b, a)) tab.save()
                    repeat(2) { listOf(a, b).forEach(Tab::save) }
                    store.board.graphs.map { it.id }.shouldBeUnique()
                    (mine.isDone(store.board, "A") to theirs.isDone(store.board, "B")) shouldBe (true to true)
                    store.board.graphs.count { it.title == "C" } shouldBe 1
                }
            }
        }
    }

    test("undoing in one tab undoes only its own changes") {
        checkAll(Arb.list(Arb.int(0..7), 0..30)) { all ->
            val store = Store(start)
            val tabs = List(2) { Tab(store) }
            val heights = mutableListOf<Int?>(null, null)
            val steps = List(2) { ArrayList<Int?>() }
            all.forEachIndexed { i, deed ->
                val own = deed % 2
                if (deed < 6) {
                    steps[own] += heights[own]
                    heights[own] = 60 + i
                    tabs[own].change { resized(start.graphs[own].id, 60 + i) }
                } else if (steps[own].isNotEmpty()) {
                    heights[own] = steps[own].removeLast()
                    tabs[own].take { undone() }
                }
            }
            store.board.graphs.take(2).map { it.height } shouldBe heights
        }
    }

    test("whenever tabs remember, the board has the changes of all, and undoing takes back only those of the own tab") {
        val own = Arb.list(arbitrary { Deed(Arb.int(0..2).bind(), Arb.int(0..6).bind(), Arb.int(0..6).bind(), Arb.int(60..600).bind()) }, 0..60)
        checkAll(own) { all ->
            val store = Store(start)
            val tabs = List(3) { Tab(store) }
            for (deed in all) {
                val tab = tabs[deed.tab]
                // Each tab has a graph of its own, and no other tab undoes anything in it.
                val id = start.graphs[deed.tab].id
                when (deed.kind) {
                    0 -> tab.later { changed(now.withGraph(listOf("New ${deed.tab} ${deed.value}"))) }
                    1 -> tab.later { changed(now.resized(id, deed.value)) }
                    2 -> tab.later { changed(now.moved(id, deed.value % 3 - 1)) }
                    3 -> tab.later { undone() }
                    4 -> tab.later { redone() }
                    5 -> tab.later { changed(now.withoutSignal("New ${deed.tab} ${deed.value}")) }
                    else -> tab.save()
                }
            }
            // At the end, the boards have each tab's own changes that it has not undone.
            val wanted = tabs.mapIndexed { i, tab -> tab.board.graphs.filter { it.id == start.graphs[i].id || "New $i" in it.title }.map { it.copy(id = 0) }.toSet() }
            tabs.forEach(Tab::save)
            store.board.graphs.map { it.id }.shouldBeUnique()
            store.board.graphs.map { it.copy(id = 0) }.toSet() shouldBe wanted.flatten().toSet()
        }
    }

    test("tabs that begin with the same graphs recognize them, in any order and beside others") {
        fun begun(vararg lines: String) = Board(lines.map { BoardGraph(0, it, listOf(it)) }).identifiedByLines()
        val (mine, theirs) = begun("A", "B", "C") to begun("C", "B", "D")
        mine.graphs.takeLast(2).map { it.id }.toSet() shouldBe theirs.graphs.take(2).map { it.id }.toSet()
        begun("A", "A").graphs.map { it.id }.shouldBeUnique()
        BoardHistory(Board()) { 7 }.changed(mine).now shouldBe mine
        val changed = mine.resized(mine.graphs[1].id, 100)
        changed.mergedWith(stored = theirs.resized(theirs.graphs[0].id, 200), read = mine).graphs.map { it.title to it.height } shouldBe
            listOf("C" to 200, "B" to 100, "D" to null)
    }

    test("a change of the part that a log can show keeps the graphs and lines that it cannot show") {
        val whole = start.withGraph(listOf("Hidden"))
        val shown = whole.fittedTo { it != "Hidden" && it != "C" }.board
        val changed = BoardHistory(whole) { 77 }.changed(shown.moved(3, -2).resized(2, 90).withGraph(listOf("E")), shown).now
        changed.graphs.map { it.lines } shouldBe listOf(listOf("D"), listOf("Hidden"), listOf("A"), listOf("B", "C"), listOf("E"))
        changed.graphs[3].height shouldBe 90
    }

    test("a graph that was never on the board is another one, even if it has the id of a removed one") {
        val store = Store(start)
        val (mine, theirs) = List(2) { Tab(store) }
        mine.change { without(3) }
        mine.change { withGraph(listOf("E")) }
        theirs.change { without(3).withGraph(listOf("F")) }
        store.board.graphs.map { it.title } shouldBe listOf("A", "B", "F", "E")
    }
})
