package badlog.viewer.choices.board

import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe

private const val VOLTAGE = "SystemStats/BatteryVoltage"
private const val CURRENT = "PowerDistribution/TotalCurrent"
private const val LOOP = "RealOutputs/LoggedRobot/FullCycleMS"

private fun topic(name: String, unit: String = "", to: Double = 2.0): Topic = timedTopic(name, 0.0 to 1.0, 4.0 to to).copy(unit = unit)

private fun logOf(others: Int, vararg topics: Topic): LogView = timedView(*Array(others) { topic("Dashboard/Value $it") }, *topics)

private fun above(view: LogView, vararg pointed: String) = boardAbove(view, RuleSet.BUILT_IN.signals, pointed.toList()).graphs.map { it.title to it.lines }

class BoardAboveSpec : FunSpec({
    val power = arrayOf(topic(VOLTAGE, "V"), topic(CURRENT, "A"), topic(LOOP, "ms"))

    test("a log of few graphs, which are close together, has no board above them") {
        above(logOf(7, *power), "Dashboard/Value 1") shouldBe emptyList()
    }

    test("a log of more graphs has battery and current together above them, then the loop time, then findings' topics") {
        above(logOf(8, *power), CURRENT, "Dashboard/Value 3", "Dashboard/Value 5", "Not logged") shouldBe listOf(
            "Battery and current" to listOf(VOLTAGE, CURRENT),
            LOOP to listOf(LOOP),
            "Dashboard: Value 3, Value 5" to listOf("Dashboard/Value 3", "Dashboard/Value 5"),
        )
    }

    test("topics that never change, and unknown ones, are not among them") {
        above(logOf(12, topic(VOLTAGE, "V"), topic(CURRENT, "A", to = 1.0))) shouldBe listOf(VOLTAGE to listOf(VOLTAGE))
        above(logOf(12)) shouldBe emptyList()
        val large = above(logOf(70, topic(VOLTAGE, "V"), topic(CURRENT, "A", to = 1.0))).map { it.second }
        large.first() shouldBe listOf(VOLTAGE)
        large.flatten() shouldNotContain CURRENT
    }

    test("a large log has findings' topics after the signals, and no more graphs than a person looks through") {
        val board = boardAbove(logOf(70, *power), RuleSet.BUILT_IN.signals, listOf("Dashboard/Value 60"))
        board.graphs.map { it.lines.first() }.take(4) shouldBe listOf(VOLTAGE, CURRENT, LOOP, "Dashboard/Value 60")
        board.graphs.size shouldBeLessThanOrEqual 24
    }

    test("if all graphs are on the board, the upper ones are not repeated below") {
        val board = standardBoard(logOf(12, *power), RuleSet.BUILT_IN.signals, listOf("Dashboard/Value 3"))
        board.graphs.map { it.lines }.take(3) shouldBe listOf(listOf(VOLTAGE, CURRENT), listOf(LOOP), listOf("Dashboard/Value 0"))
        board.graphs.flatMap { it.lines }.groupingBy { it }.eachCount().values.toSet() shouldBe setOf(1)
        board.graphs.size shouldBe 2 + 12
    }
})
