package badlog.viewer.choices.board

import badlog.core.analysis.Span
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class BoardLayoutSpec : FunSpec({
    val board = Board().withGraph(listOf("Arm/Angle", "Arm/Goal")).withYRange(1, Span(-1.5, 90.0))

    test("a layout is read back as written") {
        checkAll(Arb.string(0..20)) { name ->
            val written = BoardLayout(Board().withGraph(listOf(name, "B")).withLineHidden(1, "B", true), Span(1.5, 90.25), listOf("$name = 1"))
            val read = boardLayoutOf("a", written.toJson())
            read.board shouldBe written.board
            read.visible shouldBe written.visible
            read.formulas shouldBe written.formulas
        }
        boardLayoutOf("a", BoardLayout(null).toJson()).board shouldBe null
        boardLayoutOf("a", BoardLayout(Board()).toJson()).board shouldBe Board()
    }

    test("a layout saved by the window is read, except for the window's own parts") {
        val file = """{
            "badlog-layout": 1,
            "graphs": [{"title": "Arm/Angle", "lines": ["Arm/Angle", "Arm/Goal"], "y": {"from": -1.5, "to": 90.0}}],
            "recording": "a.bag",
            "visible": {"from": 1.0, "to": 2.5},
            "selection": {"from": 1.0, "to": 2.0},
            "compared": {"files": ["b.bag"], "alignment": "start", "offsets": {}},
            "panels": {"library": true, "topics": false, "main": "GRAPHS"},
            "formulas": ["Power [W] = Voltage * Current"]
        }"""
        boardLayoutOf("a", file).run {
            this.board shouldBe board
            visible shouldBe Span(1.0, 2.5)
            formulas shouldBe listOf("Power [W] = Voltage * Current")
        }
    }

    test("a file that is not a layout is refused in a sentence with its name") {
        for (text in listOf("[]", "{\"graphs\":[]}")) {
            shouldThrow<BoardException> { boardLayoutOf("my.json", text) }.message shouldBe
                "my.json is not a layout, or is damaged; select a file that badlog has saved."
        }
        shouldThrow<BoardException> { boardLayoutOf("my.json", "{\"badlog-layout\":2}") }.message shouldBe
            "my.json was saved by a newer badlog; update badlog to open it."
    }

    test("a mistake in a layout is reported with its line and column") {
        val mistakes = listOf(
            "" to "my.json is not a layout, or is damaged in line 1, column 1; select a file that badlog has saved.",
            "{\n \"badlog-layout\": 1,\n}" to "my.json is not a layout, or is damaged in line 3, column 1; select a file that badlog has saved.",
            "{\"badlog-layout\": 1,\n \"graphs\": [\n  {\"title\": \"A\"}]}" to
                "The graphs are damaged: graph 1 has no list of “lines” (line 3, column 3); select a file that badlog has saved.",
            "{\"badlog-layout\": 1,\n \"graphs\": [{\"title\": \"A\", \"lines\": [\"A\"], \"height\": \"x\"}]}" to
                "The graphs are damaged: “height” of graph 1 is not a number (line 2, column 54); select a file that badlog has saved.",
        )
        for ((text, sentence) in mistakes) shouldThrow<BoardException> { boardLayoutOf("my.json", text) }.message shouldBe sentence
    }

    test("keys go through the kept layouts in their order, wrap around, and begin at either end") {
        val kept = listOf("Auto", "Drive", "Power")
        keptLayoutAfter(kept, null, 1) shouldBe "Auto"
        keptLayoutAfter(kept, null, -1) shouldBe "Power"
        keptLayoutAfter(kept, "Auto", 1) shouldBe "Drive"
        keptLayoutAfter(kept, "Power", 1) shouldBe "Auto"
        keptLayoutAfter(kept, "Auto", -1) shouldBe "Power"
        keptLayoutAfter(kept, "one that was removed", 1) shouldBe "Auto"
        keptLayoutAfter(listOf("Auto"), "Auto", 1) shouldBe "Auto"
        keptLayoutAfter(emptyList(), "Auto", 1) shouldBe null
    }

    test("a cut or changed layout is a layout or refused in a sentence") {
        val whole = BoardLayout(board, Span(0.0, 1.0), listOf("a = 1")).toJson()
        checkAll(Arb.int(0..whole.length), Arb.string(0..2)) { at, put ->
            for (broken in listOf(whole.take(at), whole.take(at) + put + whole.drop(at + 1))) {
                try {
                    boardLayoutOf("a", broken)
                } catch (e: BoardException) {
                    e.message!! shouldEndWith "."
                }
            }
        }
    }
})
