package badlog.viewer.panel

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Severity
import badlog.viewer.state.Action
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class ProblemsPanelSpec : FunSpec({
    val lost = Problem(ProblemKind.ROW_CUT, "A row is cut.", line = 12)
    val short = Problem(ProblemKind.ROW_SHORT, "A row is short.")
    val blank = Problem(ProblemKind.BLANK_LINE, "A line is blank.")
    val wrong = Trouble("addition 0", Severity.WARNING, "A formula is wrong.")

    fun List<Part>.texts(): List<String> = flatMap { part ->
        when (part) {
            is Trouble -> listOf(part.text)
            is Rows -> part.rows.texts()
            is Fold -> part.parts.texts()
            else -> emptyList()
        }
    }

    fun above(problems: List<Problem>, others: List<Trouble> = emptyList(), unfolded: Map<String, Boolean> = emptyMap(), room: PanelRoom = PanelRoom.SHARED) = problemsAbove(problems, others, unfolded, room)

    fun isOpen(problems: List<Problem>, others: List<Trouble> = emptyList(), chosen: Boolean? = null, room: PanelRoom = PanelRoom.SHARED): Boolean {
        val fold = above(problems, others, chosen?.let { mapOf("problems" to it) }.orEmpty(), room).single() as Fold
        fold.parts.isEmpty() shouldBe !fold.isOpen
        fold.toggle.shouldBeInstanceOf<Action.Unfold>().run { this.fold to this.isOpen } shouldBe ("problems" to !fold.isOpen)
        return fold.isOpen
    }

    test("a panel of its own lists all problems below a summary, the worst first, each with its word and place") {
        val parts = problemsPanel(listOf(blank, short, lost))
        (parts.first() as Heading).status shouldBe "Data is missing in 1 place, 1 warning, 1 hint."
        parts.texts() shouldBe listOf("A row is cut.", "A row is short.", "A line is blank.")
        val rows = parts.filterIsInstance<Rows>().single().rows.filterIsInstance<Trouble>()
        rows.map { it.word } shouldBe listOf("lost", "warning", "hint")
        rows.map { it.place } shouldBe listOf("line 12", "", "")
        (problemsPanel(emptyList()).first() as Heading).status shouldBe "Complete."
    }

    test("above graphs they are one line, marked by the worst; without problems, there is nothing") {
        above(emptyList()).shouldBeEmpty()
        for ((problems, worst) in listOf(listOf(blank, lost) to Severity.ERROR, listOf(short, blank) to Severity.WARNING, listOf(blank) to Severity.NOTE)) {
            (above(problems).single() as Fold).severity shouldBe worst
        }
        (above(listOf(blank), listOf(wrong)).single() as Fold).run { severity to title } shouldBe (Severity.WARNING to "Complete, 1 warning, 1 hint.")
    }

    test("up to five losses are listed at once, and other warnings; a person’s choice precedes") {
        isOpen(listOf(short, blank)) shouldBe false
        isOpen(List(5) { lost }) shouldBe true
        isOpen(List(6) { lost }) shouldBe false
        isOpen(List(6) { lost }, chosen = true) shouldBe true
        isOpen(List(5) { lost }, chosen = false) shouldBe false
        isOpen(List(6) { lost }, listOf(wrong)) shouldBe true
    }

    test("a phone lists only other warnings at once, unless losses would be listed with them") {
        isOpen(listOf(lost), room = PanelRoom.NARROW) shouldBe false
        isOpen(listOf(lost), chosen = true, room = PanelRoom.NARROW) shouldBe true
        isOpen(listOf(lost, blank), listOf(wrong), room = PanelRoom.NARROW) shouldBe true
        isOpen(listOf(lost, lost), listOf(wrong), room = PanelRoom.NARROW) shouldBe false
    }

    test("paper lists at least what a wide screen lists at once, even if it is folded there") {
        isOpen(listOf(lost), chosen = false, room = PanelRoom.PAPER) shouldBe true
        isOpen(List(6) { lost }, room = PanelRoom.PAPER) shouldBe false
        isOpen(List(6) { lost }, chosen = true, room = PanelRoom.PAPER) shouldBe true
    }

    test("above graphs, other warnings follow losses, and hints are folded below anything worse") {
        val opened = mapOf("problems" to true)
        above(listOf(blank), unfolded = opened).texts() shouldBe listOf("A line is blank.")
        val all = listOf(blank, short, lost)
        above(all, listOf(wrong), opened).texts() shouldBe listOf("A row is cut.", "A formula is wrong.", "A row is short.")
        above(all, listOf(wrong), opened + ("hints" to true)).texts().last() shouldBe "A line is blank."
    }
})
