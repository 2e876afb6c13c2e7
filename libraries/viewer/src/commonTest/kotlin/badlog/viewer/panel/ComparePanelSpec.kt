package badlog.viewer.panel

import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.shown.comparison.DrawnLog
import badlog.viewer.state.Action
import badlog.viewer.state.CompareRequest
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class ComparePanelSpec : FunSpec({
    class Log(override val name: String, override val offset: Double) : DrawnLog

    val two = listOf(Log("a.bag", -1.5), Log("b.bag", 0.25))

    fun Action.request() = shouldBeInstanceOf<Action.Ask>().request
    fun List<Part>.rows() = filterIsInstance<Rows>().single().rows

    test("without another log there is nothing; one that is being read is named") {
        comparePanel(Alignment.START, "open.bag", emptyList()).shouldBeEmpty()
        val rows = comparePanel(Alignment.START, "open.bag", emptyList(), listOf("big.bag")).rows()
        (rows.last() as Paragraph).text shouldBe "Reading big.bag…"
    }

    test("each log has its color and offset, the open one first") {
        val rows = comparePanel(Alignment.START, "open.bag", two).rows().map { it as Value }
        rows.map { it.name to it.text } shouldContainExactly listOf("open.bag" to "open", "a.bag" to "-1.5", "b.bag" to "0.25")
        rows.map { it.color } shouldContainExactly listOf(0, 1, 2)
        rows.first().tools.shouldBeEmpty()
    }

    test("a log is moved by steps and by typing, where only a number counts, and removed") {
        val log = comparePanel(Alignment.START, "open.bag", two).rows()[2] as Value
        fun Action.move() = request().shouldBeInstanceOf<CompareRequest.Move>().let { it.log to it.offset }
        log.tools.first { it.label == "+.1" }.action.move() shouldBe (1 to 0.35)
        log.tools.last().action.request().shouldBeInstanceOf<CompareRequest.Remove>().log shouldBe 1
        val field = log.field!!
        field.onText("-2,5").move() shouldBe (1 to -2.5)
        field.isValid("fast") shouldBe false
    }

    test("one alignment is on") {
        val choice = comparePanel(Alignment.ENABLED, "open.bag", two).firstNotNullOf { it as? Choice }
        choice.options.filter { it.isOn == true }.map { it.label } shouldContainExactly listOf("Enabled")
        choice.options.map { it.action.request().shouldBeInstanceOf<CompareRequest.Align>().alignment } shouldContainExactly Alignment.entries
    }
})
