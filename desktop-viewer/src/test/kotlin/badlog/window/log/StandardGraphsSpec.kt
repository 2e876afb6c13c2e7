package badlog.window.log

import badlog.viewer.choices.board.defaultBoard
import badlog.window.graph.recordingOf
import badlog.window.graph.sample
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe

class StandardGraphsSpec : FunSpec({
    fun logOf(names: List<String>, cell: (name: String, row: Int) -> String): OpenRecording {
        val all = listOf("Time") + names
        val described = all.joinToString(",") { """{"name":"$it","unit":"ul","attrs":[${if (it == "Time") "\"xaxis\"" else ""}]}""" }
        val rows = List(5) { row -> (listOf("$row") + names.map { cell(it, row) }).joinToString(",") }
        return recordingOf((listOf("""{"topics":[$described],"values":[]}""", all.joinToString(",")) + rows).joinToString("\n", postfix = "\n"))
    }

    test("a log of hundreds of topics begins with a few graphs of its signals; the topics stay in the list") {
        val names = List(300) { "Dashboard $it/Value" } +
            listOf("/SystemStats/BatteryVoltage", "/PowerDistribution/TotalCurrent", "/DriverStation/Enabled", "/RealOutputs/LoggedRobot/FullCycleMS")
        val open = logOf(names) { name, row -> if (name == "/DriverStation/Enabled") "${row > 2}" else "${row + name.length}" }
        val graphs = open.standardGraphs.graphs
        graphs.take(5).map { it.lines } shouldBe listOf(
            listOf("/SystemStats/BatteryVoltage"),
            listOf("/PowerDistribution/TotalCurrent"),
            listOf("/DriverStation/Enabled"),
            listOf("/RealOutputs/LoggedRobot/FullCycleMS"),
            listOf("Dashboard 0/Value"),
        )
        graphs.size shouldBeLessThanOrEqual 24
        open.signals.size shouldBe names.size
    }

    test("a small log begins with the graphs that explain most of a match, then all others that its attributes define") {
        val match = sample("qualification-42.bag")
        val graphs = match.standardGraphs.graphs
        graphs.first().title shouldBe "Battery and current"
        graphs.flatMap { it.lines }.toSet() shouldBe defaultBoard(match.logged).graphs.flatMap { it.lines }.toSet()
    }
})
