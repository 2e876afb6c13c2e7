package badlog.viewer.text

import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class ProblemTextSpec : FunSpec({
    test("a problem says where and how often it occurred") {
        val cut = Problem(ProblemKind.ROW_CUT, "A row is cut.", line = 12, count = 3)
        placeTextOf(cut) shouldBe "line 12 · 3 times"
        placeTextOf(cut.copy(topic = "Arm/Angle", count = 1)) shouldBe "line 12 · Arm/Angle"
        placeTextOf(Problem(ProblemKind.BLANK_LINE, "A line is blank.")) shouldBe ""
    }

    test("a number with which a problem begins is not repeated") {
        placeTextOf(Problem(ProblemKind.ROW_CUT, "27 records were dropped.", topic = "Mode", count = 27)) shouldBe "Mode"
        placeTextOf(Problem(ProblemKind.EMPTY_CELLS, "“Mode” is empty in 27 of 400 cells.", count = 27)) shouldBe ""
        placeTextOf(Problem(ProblemKind.BAD_RECORD, "Records were dropped (27×).", count = 27)) shouldBe ""
        placeTextOf(Problem(ProblemKind.ROW_CUT, "271 records were dropped.", count = 27)) shouldBe "27 times"
    }
})
