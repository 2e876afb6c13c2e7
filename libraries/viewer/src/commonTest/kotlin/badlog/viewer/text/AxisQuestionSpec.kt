package badlog.viewer.text

import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class AxisQuestionSpec : FunSpec({
    fun questionOver(vararg times: Int) = axisQuestion(bagView(listOf("Robot/Time"), times.map { "$it" }).recording.topics.single()).substringAfter(". ")

    test("the question says in how many rows the time does not increase, if there are any") {
        questionOver(0, 1, 2) shouldBe "“Time” increases in every row."
        questionOver(0, 5, 1, 6, 7) shouldBe "“Time” increases in all but 1 of 5 rows."
    }
})
