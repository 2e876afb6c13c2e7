package badlog.expression

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.shouldBeNaN
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs

private const val HEADER = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"PDP/Voltage","unit":"V"},""" +
    """{"name":"PDP/Current","unit":"A"}],"values":[]}"""

private fun viewOf(vararg rows: String): LogView {
    val text = HEADER + "\nTime,PDP/Voltage,PDP/Current\n" + rows.joinToString("") { it + "\n" }
    return LogView.of(BagParser().apply { accept(text.encodeToByteArray()) }.finish())
}

private fun LogView.topic(name: String): Topic = recording.topics.single { it.name == name }

private fun LogView.points(name: String) = seriesOf(topic(name)).data.run { x.toList().zip(y.toList()) }

class ViewWithVirtualTopicsSpec : FunSpec({
    val view = viewOf("0,12,10", "1,6,100", "2,,50", "3,11,20")

    test("a virtual topic has a graph in its folder, a unit, counts, and its formula as metadata") {
        val with = view.withVirtualTopics(listOf("PDP/Power [W] = Voltage * Current"))
        with.errors.shouldBeEmpty()
        with.topics.single().name shouldBe "PDP/Power"
        val power = with.view.topic("PDP/Power")
        power.unit shouldBe "W"
        power.kind shouldBe TopicKind.NUMERIC
        power.metadata shouldBe "= \"PDP/Voltage\" * \"PDP/Current\""
        power.counts.numbers shouldBe 3
        power.counts.gaps shouldBe 1
        with.view.folders.single { it.name == "PDP" }.graphs.map { it.name } shouldBe
            listOf("PDP/Voltage", "PDP/Current", "PDP/Power")
        with.view.points("PDP/Power").map { it.first } shouldBe listOf(0.0, 1.0, 2.0, 3.0)
        power.samples[1] shouldBe 600.0
        power.samples[2].shouldBeNaN()
    }

    test("virtual topics made step by step equal those made at once, and are missing until then") {
        val definitions = listOf("Power = Voltage * Current", "Wrong = Speed", "Half = Power / 2")
        val draft = VirtualTopicsDraft(view, definitions, LogViewSignals(view))
        val shares = generateSequence { draft.share.takeIf { draft.step() } }.toList()
        shares shouldBe listOf(0.0, 1 / 3.0, 2 / 3.0)
        val whole = view.withVirtualTopics(definitions)
        draft.extended.errors.map { it.message } shouldBe whole.errors.map { it.message }
        draft.extended.view.points("Half") shouldBe whole.view.points("Half")
        VirtualTopicsDraft(view, listOf("Wrong = Speed"), LogViewSignals(view)).run { step() to extended.view } shouldBe (false to view)
    }

    test("a topic is removed without recalculating the others") {
        val with = view.withVirtualTopics(listOf("Power = Voltage * Current", "Twice = 2 * Voltage")).view
        val without = with.withoutTopics(setOf("Power"))
        without.recording.topics.map { it.name } shouldBe listOf("Time", "PDP/Voltage", "PDP/Current", "Twice")
        without.topic("Twice") shouldBeSameInstanceAs with.topic("Twice")
    }

    test("a virtual topic over all rows shares the rows, and can be written with the others") {
        val power = view.withVirtualTopics(listOf("Power = Voltage * Current")).view.topic("Power")
        power.times shouldBe null
        power.size shouldBe 4
    }

    test("a condition is a topic of truth values") {
        val low = view.withVirtualTopics(listOf("Low = Voltage < 7")).view.topic("Low")
        low.kind shouldBe TopicKind.BOOLEAN
        low.samples[1] shouldBe 1.0
    }

    test("definitions can use those before them, and one that fails does not affect the others") {
        val with = view.withVirtualTopics(listOf("Double = 2 * Voltage", "Wrong = Voltag * 2", "Double = 1", "Four = 2 * Double"))
        with.topics.map { it.name } shouldBe listOf("Double", "Four")
        with.errors.map { it.text } shouldBe listOf("Wrong = Voltag * 2", "Double = 1")
        with.view.points("Four").first() shouldBe (0.0 to 48.0)
    }

    test("if rows have gaps in time, a virtual topic has its own times, and the others keep the rows' x") {
        val gaps = viewOf("0,12,10", ",6,100", "2,10,50")
        val with = gaps.withVirtualTopics(listOf("Power = Voltage * Current")).view
        with.topic("Power").times?.toList() shouldBe listOf(0.0, 2.0)
        with.points("Power") shouldBe listOf(0.0 to 120.0, 2.0 to 500.0)
        with.points("PDP/Voltage") shouldBe listOf(0.0 to 12.0, 2.0 to 10.0)
        with.xAxis.title shouldBe "Time (s)"
        with.xAxis.topic?.name shouldBe "Time"
        with.xAxis.clocks.size shouldBe 2
        with.problems.map { it.kind } shouldBe gaps.problems.map { it.kind }
    }

    test("one number for the whole log is a line from its start to its end") {
        view.withVirtualTopics(listOf("Lowest = min(Voltage)")).view.points("Lowest") shouldBe listOf(0.0 to 6.0, 3.0 to 6.0)
    }

    test("without any virtual topic the view is the same") {
        view.withVirtualTopics(emptyList()).view shouldBeSameInstanceAs view
        view.withVirtualTopics(listOf("no formula")).view shouldBeSameInstanceAs view
    }

    test("in a recording without rows, a virtual topic has no samples") {
        val with = viewOf().withVirtualTopics(listOf("Power = Voltage * Current"))
        with.view.points("Power").shouldBeEmpty()
        with.view.xAxis.range shouldBe null
    }
})
