package badlog.viewer.text

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class ProblemTextSpec : FunSpec({
    test("a summary says whether data is lost, and counts the other problems") {
        val hint = Problem(ProblemKind.BLANK_LINE, "A line is blank.")
        val warning = Problem(ProblemKind.ROW_SHORT, "A row is short.")
        val cut = Problem(ProblemKind.ROW_CUT, "A row is cut.")
        problemSummary(emptyList()) shouldBe "Complete."
        problemSummary(listOf(hint, warning)) shouldBe "Complete, 1 warning, 1 hint."
        problemSummary(listOf(cut)) shouldBe "Data is missing in 1 place."
        problemSummary(listOf(cut, warning, cut), others = 1) shouldBe "Data is missing in 2 places, 2 warnings."
        problemSummary(listOf(hint, Problem(ProblemKind.EMPTY_FILE, "The file is empty."))) shouldBe "The file is empty."
        listOf(cut, warning, hint).map { it.word } shouldContainExactly listOf("lost", "warning", "hint")
    }

    test("a problem has its place and its count") {
        val cut = Problem(ProblemKind.ROW_CUT, "A row is cut.", line = 12, count = 3)
        placeTextOf(cut) shouldBe "line 12 · 3 times"
        placeTextOf(cut.copy(topic = "Arm/Angle", count = 1)) shouldBe "line 12 · Arm/Angle"
        placeTextOf(Problem(ProblemKind.BLANK_LINE, "A line is blank.")) shouldBe ""
    }

    test("a number in a problem's message is not repeated") {
        placeTextOf(Problem(ProblemKind.ROW_CUT, "27 records were dropped.", topic = "Mode", count = 27)) shouldBe "Mode"
        placeTextOf(Problem(ProblemKind.EMPTY_CELLS, "“Mode” is empty in 27 of 400 cells.", count = 27)) shouldBe ""
        placeTextOf(Problem(ProblemKind.BAD_RECORD, "Records were dropped (27×).", count = 27)) shouldBe ""
        placeTextOf(Problem(ProblemKind.ROW_CUT, "271 records were dropped.", count = 27)) shouldBe "27 times"
    }
})
