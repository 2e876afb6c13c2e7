package badlog.viewer.choices.board

import badlog.core.analysis.Span
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldMatch
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.alphanumeric
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class BoardSpec : FunSpec({
    val name = Arb.choice(
        Arb.string(0..12),
        Arb.string(1..8, Codepoint.alphanumeric()),
        Arb.element("Arm/Angle", "t=1", "a,b;c", "~0041", "+", "Größe [m]", "\uD800", "\u2028", "角度", "\"quoted\"", "null", "\n"),
        Arb.element("I[0]", "I[1]", "I[2]", "I[11]", "I[01]", "I[0]/x", "I[1]/x", "I[1][0]", "[2]", "I[", "I[]", "I]0[", "I[-1]", "I[4294967297]", "I[2147483647]", "I:0:"),
    )
    // Adding zero makes 0 of -0: JavaScript does not write the sign of -0.
    val range = arbitrary { Span(Arb.numericDouble(-1e9, 1e9).bind() + 0.0, 2e9) }
    val graph = arbitrary {
        val lines = Arb.list(name, 0..5).bind().distinct()
        BoardGraph(
            id = 0,
            title = name.bind(),
            lines = lines,
            isFilled = Arb.boolean().bind(),
            includesZero = Arb.boolean().bind(),
            yRange = Arb.choice(range, Arb.constant(Span(-1e-300, 1e300))).orNull().bind(),
            height = Arb.int(BoardGraph.HEIGHTS).orNull().bind(),
            rightYRange = range.orNull().bind(),
            sharesY = Arb.boolean().bind(),
            hidden = lines.filterTo(HashSet()) { Arb.boolean().bind() },
            isXy = Arb.boolean().bind(),
            xRange = range.orNull().bind(),
            origin = Arb.enum<FieldOrigin>().bind(),
        )
    }
    val board = arbitrary { Board(Arb.list(graph, 0..6).bind().mapIndexed { i, it -> it.copy(id = i + 1) }) }

    fun Board.lines() = graphs.map { it.lines }

    test("the ids of graphs are read back, if each occurs once") {
        val first = BoardGraph(70, "A", listOf("A"))
        val two = Board(listOf(first, first.copy(id = 2), first.copy(id = 90)))
        boardOfJson(two.toJson(haveIds = true)) shouldBe two
        boardOfJson(two.toJson()) shouldBe two.renumbered()
        boardOfJson(Board(listOf(first, first)).toJson(haveIds = true)).graphs.map { it.id } shouldBe listOf(1, 2)
    }

    test("a written board is read back the same, as JSON and as the text of an address") {
        checkAll(board) {
            boardOfJson(it.toJson()) shouldBe it
            boardOfText(it.toText()) shouldBe it
            it.toText() shouldMatch Regex("[-A-Za-z0-9_./:;,=+~]*")
        }
    }

    test("any text is a board or refused in a sentence") {
        val pieces = Arb.element("{", "}", "\"graphs\":", "[", "]", "\"title\":\"a\"", "\"lines\":", "1e999", "null", ",", "~", "t=", "y=1:", ";", "h=9e9")
        val text = Arb.choice(Arb.string(0..40), Arb.list(pieces, 0..20).let { lists -> arbitrary { lists.bind().joinToString("") } })
        checkAll(text) {
            for (read in listOf(::boardOfJson, ::boardOfText)) {
                try {
                    read(it)
                } catch (e: BoardException) {
                    e.message!! shouldEndWith "."
                }
            }
        }
    }

    test("a cut or changed text is a board or refused in a sentence") {
        checkAll(board, Arb.int(0..200), Arb.string(0..2)) { whole, at, put ->
            for ((text, read) in listOf(whole.toJson() to ::boardOfJson, whole.toText() to ::boardOfText)) {
                for (broken in listOf(text.take(at), text.take(at) + put + text.drop(at + 1))) {
                    try {
                        read(broken)
                    } catch (e: BoardException) {
                        e.message!! shouldEndWith "."
                    }
                }
            }
        }
    }

    test("the graphs of a layout file of version 1 are read, with any other content") {
        val file = """{"badlog-layout": 1, "graphs": [
            {"title": "Arm", "lines": ["Arm/Angle", "Arm/Goal"], "zero": true, "y": {"from": -1.5, "to": 90.0}},
            {"title": "Mode", "lines": ["Mode"], "y": {"from": 2.0, "to": 1.0}, "log": true}
        ], "recording": "a.bag", "panels": {"library": false}}"""
        boardOfJson(file).graphs shouldBe listOf(
            BoardGraph(1, "Arm", listOf("Arm/Angle", "Arm/Goal"), includesZero = true, yRange = Span(-1.5, 90.0)),
            BoardGraph(2, "Mode", listOf("Mode")),
        )
    }

    test("a board has its version, one without is of version 1, and one of a newer badlog is refused") {
        val text = Board().withGraph(listOf("Mode")).toJson()
        text shouldBe """{"badlog-layout":1,"graphs":[{"title":"Mode","lines":["Mode"]}]}"""
        for (old in listOf(text, """{"graphs":[{"title":"Mode","lines":["Mode"]}]}""")) boardOfJson(old).lines() shouldBe listOf(listOf("Mode"))
        shouldThrow<BoardException> { boardOfJson(text.replace(":1,", ":2,")) }.message shouldBe
            "The graphs were saved by a newer badlog; update badlog to open them."
    }

    test("a mistake is reported with the next step") {
        val wrong = mapOf(
            """[]""" to "This is not a JSON object; select a file that badlog has saved.",
            """{"graphs":"all"}""" to "The graphs are damaged: “graphs” is not a list; select a file that badlog has saved.",
            """{"graphs":[{"lines":["a"]}]}""" to "The graphs are damaged: graph 1 has no “title”; select a file that badlog has saved.",
        )
        for ((text, sentence) in wrong) shouldThrow<BoardException> { boardOfJson(text) }.message shouldBe sentence
        shouldThrow<BoardException> { boardOfText("A,q=1") }.message shouldBe
            "Graph 1 has “q”, which is unknown here; update badlog to open this."
    }

    test("an unknown origin is reported") {
        shouldThrow<BoardException> { boardOfText("A,B,p=,o=green") }.message shouldBe
            "“green” is not an origin of poses; copy the whole address again."
    }

    test("an address is short") {
        val chosen = BoardGraph(1, "Arm", listOf("Arm/Angle", "Goal (deg)"), isFilled = true, yRange = Span(0.5, 90.25), height = 120)
        Board(listOf(chosen, BoardGraph(2, "Mode", listOf("Mode")))).toText() shouldBe
            "Arm/Angle,Goal+~0028deg~0029,t=Arm,f=,y=0.5:90.25,h=120;Mode"
    }

    test("the elements of an array are a range in an address") {
        val modules = (0..3).map { "Modules[$it]/speed" }
        val lines = modules + listOf("Currents[7]", "Currents[9]", "Currents[8]", "Mode")
        Board(listOf(BoardGraph(1, modules[0], lines, hidden = setOf("Mode")))).toText() shouldBe
            "Modules:0-3:/speed,Currents:7:,Currents:9:,Currents:8:,Mode,x=7"
        shouldThrow<BoardException> { boardOfText((0..20).joinToString(",") { "Modules$it:0-999:" }) }.message shouldBe
            "Graph 1 has more lines than can be drawn; copy the whole address again."
        for (range in listOf("3-0", "-3", "0-", "0-4000", "a", "")) {
            shouldThrow<BoardException> { boardOfText("Modules:$range:/speed") }.message shouldBe
                "“$range” is not a range of elements; copy the whole address again."
        }
    }

    test("elements of an array in older links are read") {
        boardOfText("Modules~005b0~005d/speed,Modules~005b1~005d/speed").lines() shouldBe listOf(listOf("Modules[0]/speed", "Modules[1]/speed"))
    }

    test("after any changes, a board's graphs have unique ids, and lines, each once") {
        checkAll(Arb.list(Arb.int(0..9), 0..30), Arb.list(Arb.element("A", "B", "C", "D"), 30..30)) { deeds, names ->
            var now = Board()
            deeds.forEachIndexed { i, deed ->
                val id = i % 5 + 1
                now = when (deed) {
                    0, 1 -> now.withGraph(listOf(names[i], names[29 - i]), before = id)
                    2 -> now.withLine(id, names[i])
                    3 -> now.withoutLine(id, names[i])
                    4 -> now.joined(id, i % 3 + 1)
                    5 -> now.separated(id)
                    6 -> now.moved(id, i - 15)
                    7 -> now.renamed(names[i], names[29 - i]).withLineHidden(id, names[29 - i], i % 2 == 0)
                    8 -> now.withoutSignal(names[i]).movedBefore(id, i % 4)
                    else -> now.without(id).resized(id + 1, i * 100)
                }
                now.graphs.map { it.id }.shouldBeUnique()
                for (graph in now.graphs) (graph.lines.isNotEmpty() && graph.lines.distinct() == graph.lines) shouldBe true
                for (graph in now.graphs) (graph.hidden - graph.lines.toSet()) shouldBe emptySet()
            }
        }
    }

    test("graphs are joined, separated and moved, and have possible heights") {
        val two = Board().withGraph(listOf("A", "B")).withGraph(listOf("B", "C"))
        two.joined(1, 2).lines() shouldBe listOf(listOf("A", "B", "C"))
        two.joined(1, 1) shouldBe two
        two.separated(1).lines() shouldBe listOf(listOf("A"), listOf("B"), listOf("B", "C"))
        two.separated(1).graphs.map { it.title } shouldBe listOf("A", "B", "B")
        two.moved(2, -1).lines() shouldBe listOf(listOf("B", "C"), listOf("A", "B"))
        two.resized(1, 5).graphs[0].height shouldBe 60
        two.showsSame(two.moved(2, -1).moved(2, 1)) shouldBe true
        two.showsSame(two.moved(2, -1)) shouldBe false
    }

    test("a graph is dragged before another one, or to the end") {
        val three = Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))
        three.movedBefore(3, 1).lines().map { it.single() } shouldBe listOf("C", "A", "B")
        three.movedBefore(1, 3).lines().map { it.single() } shouldBe listOf("B", "A", "C")
        three.movedBefore(1, null).lines().map { it.single() } shouldBe listOf("B", "C", "A")
        three.movedBefore(2, 2) shouldBe three
        three.movedBefore(9, 1) shouldBe three
    }

    test("limits of y are fixed or shared, never both") {
        val board = Board().withGraph(listOf("A"))
        board.withSharedY(1, true).withYRange(1, Span(0.0, 1.0)).graphs[0].sharesY shouldBe false
        board.withYRange(1, Span(0.0, 1.0), Span(0.0, 2.0)).withSharedY(1, true).graphs[0].run { listOf(yRange, rightYRange) } shouldBe listOf(null, null)
        board.withSharedY(1, true).withYRange(1, null).graphs[0].sharesY shouldBe true
    }

    test("three heights have names, and any number of pixels has the nearest one") {
        GraphHeight.of(null) shouldBe GraphHeight.MEDIUM
        GraphHeight.entries.map { GraphHeight.of(it.pixels) } shouldBe GraphHeight.entries
        GraphHeight.of(120) shouldBe GraphHeight.SMALL
        GraphHeight.of(600) shouldBe GraphHeight.LARGE
        for (height in GraphHeight.entries) (height.pixels in BoardGraph.HEIGHTS) shouldBe true
    }

    test("a board written by a newer badlog is read, except for what is unknown") {
        boardOfJson("""{"graphs":[{"title":"A","lines":["A","B"],"hidden":["B","C",3],"glow":{"color":1}}]}""").graphs shouldBe
            listOf(BoardGraph(1, "A", listOf("A", "B"), hidden = setOf("B")))
    }

    test("lines over each other are another graph than the same lines over time") {
        val over = Board().withGraph(listOf("A", "B")).withXy(1, true)
        over.has(BoardGraph(0, "A", listOf("A", "B"))) shouldBe false
        over.has(over.graphs[0]) shouldBe true
        over.toText() shouldBe "A,B,p="
        over.withPlane(1, Span(0.5, 2.5), Span(1.5, 3.5)).withOrigin(1, FieldOrigin.AUTO).toText() shouldBe "A,B,y=1.5:3.5,p=,w=0.5:2.5,o=auto"
        over.separated(1).graphs.map { it.isXy } shouldBe listOf(false, false)
        over.withXy(1, false).showsSame(Board().withGraph(listOf("A", "B"))) shouldBe true
    }

    test("swapped axes draw the first line over the second, with the visible range of each, and swapping twice undoes it") {
        val over = Board().withGraph(listOf("A", "B")).withXy(1, true).withPlane(1, Span(0.0, 1.0), Span(5.0, 7.0))
        val swapped = over.withSwappedAxes(1)
        swapped.graphs.single().run { listOf(lines, xRange, yRange) } shouldBe listOf(listOf("B", "A"), Span(5.0, 7.0), Span(0.0, 1.0))
        swapped.withSwappedAxes(1) shouldBe over
        over.graphs.single().canSwapAxes(emptyList()) shouldBe true
        over.withXy(1, false).graphs.single().canSwapAxes(emptyList()) shouldBe false
    }

    test("removing or renaming a signal changes all its graphs") {
        val board = Board().withGraph(listOf("Power")).withGraph(listOf("Power", "Other")).withGraph(listOf("Other"))
        board.withoutSignal("Power").lines() shouldBe listOf(listOf("Other"), listOf("Other"))
        val renamed = board.renamed("Power", "P")
        renamed.lines() shouldBe listOf(listOf("P"), listOf("P", "Other"), listOf("Other"))
        renamed.graphs[0].title shouldBe "P"
    }
})
