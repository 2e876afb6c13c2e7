package badlog.viewer.panel

import badlog.viewer.bagView
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.state.GraphChange
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class CursorPanelSpec : FunSpec({
    val view = bagView(listOf("Time|xaxis", "A", "B", "Mode"), listOf("0,1,5,off", "1,1,5,off", "2,1,9.123456789,off", "3,1,9,on"))
    val draw = Button("Draw B", GraphChange.Add(listOf("B")), PartIcon.PIN)

    fun panel(names: List<String>, x: Double?): List<Part> {
        val lines = names.map { name -> CursorLine(name, view.seriesOf(view.recording.topics.first { it.name == name }), draw.takeIf { name == "B" }) }
        return cursorPanel(lines, CursorValues(lines.map { it.line }, view.xAxis), x, "2 s")
    }
    fun List<Part>.values() = filterIsInstance<Rows>().single().rows.map { it as Value }
    fun List<Part>.texts() = filterIsInstance<Paragraph>().map { it.text }

    test("lines that have just changed are first and marked, with six digits, or all on request") {
        val parts = panel(listOf("A", "B"), 2.0)
        parts.texts() shouldContainExactly listOf("2 s")
        parts.values().map { Triple(it.name, it.text, it.isMarked) } shouldContainExactly listOf(Triple("B", "9.12346 V", true), Triple("A", "1 V", false))
        parts.values().first().exact() shouldBe "9.123456789 V"
        panel(listOf("A", "B"), 0.0).values().map { it.name } shouldContainExactly listOf("A", "B")
        panel(listOf("Mode"), 3.0).values().single().text shouldBe "on"
    }

    test("a line that can be drawn has the button for it") {
        panel(listOf("A", "B"), 0.0).values().map { it.tools } shouldContainExactly listOf(emptyList(), listOf(draw))
    }

    test("without a cursor, or without topics, a hint says what to do") {
        val parts = panel(listOf("A", "B"), null)
        parts.texts() shouldContainExactly listOf("Point at a graph, or click it.")
        parts.values().map { it.text } shouldContainExactly listOf("", "")
        panel(emptyList(), 2.0).texts() shouldContainExactly listOf("2 s", "No topic matches.")
    }

    test("of very many lines, only the first are listed, and the number of the others is given") {
        val parts = panel(List(250) { "A" }, 1.0)
        parts.values().size shouldBe 200
        parts.texts() shouldContainExactly listOf("2 s", "And 50 more: search to find them.")
    }
})
