package badlog.core.bag

import badlog.core.recording.Loss
import badlog.core.recording.ProblemKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class LossSpec : FunSpec({
    val header = "{\"topics\":[{\"name\":\"a\"},{\"name\":\"b\"}]}\na,b\n"

    fun losses(text: String) = parse(text).problems.associate { it.kind to it.loss }

    test("a row that is cut costs its cells and bytes") {
        losses("${header}1,2\n34")[ProblemKind.ROW_CUT] shouldBe Loss(rows = 1, cells = 1, bytes = 2)
    }

    test("a last cell that may be cut counts as lost") {
        losses("${header}1,2\n3,45")[ProblemKind.LAST_CELL_CUT] shouldBe Loss(cells = 1, bytes = 2)
    }

    test("a row that is too long costs its extra cells") {
        losses("${header}1,2,33,4\n")[ProblemKind.ROW_LONG] shouldBe Loss(cells = 2, bytes = 4)
    }

    test("a hole costs its bytes, and the remains of the row after it") {
        losses("${header}1,2\n\u0000\u0000\u00003\n4,5\n") shouldBe
            mapOf(ProblemKind.NUL_HOLE to Loss(bytes = 3), ProblemKind.ROW_CUT to Loss(rows = 1, cells = 1, bytes = 1))
    }

    test("an unreadable header costs its bytes") {
        losses("{\"topics\na,b\n1,2\n")[ProblemKind.HEADER_UNREADABLE] shouldBe Loss(bytes = 8)
    }

    test("kept data does not count as lost") {
        losses("${header}1,2\n\n3\n")[ProblemKind.ROW_SHORT] shouldBe Loss.NONE
    }

    test("the problem that counts unlisted ones includes their losses") {
        val problems = parse(header + "1,2,3\n".repeat(15)).problems
        problems.last().count shouldBe 5
        problems.map { it.loss }.reduce(Loss::plus) shouldBe Loss(cells = 15, bytes = 15)
    }
})
