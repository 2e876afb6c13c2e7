package badlog.signals.clock

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.enabledSpans
import badlog.core.bag.BagParser
import badlog.core.recording.Recording
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.signalTopicsOf
import badlog.signals.withSignals
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe

class StationOverlaySpec : FunSpec({
    val signals = RuleSet.BUILT_IN.signals

    fun beside(robot: Recording, station: Recording, seconds: Double) = StationOverlay(LogView.of(robot).withSignals(signals, "log"), clocked(station), ClockFit(seconds, 4, 0.0), signals)

    fun LogView.topic(name: String) = recording.topics.single { it.name == name }

    val station = logOf(
        listOf(
            numbers("Driver Station/Trip Time", List(100) { it.toDouble() to it / 10.0 }, "ms"),
            numbers("Driver Station/Battery Voltage", List(100) { it.toDouble() to 6.5 }, "V"),
            flag("Driver Station/Enabled", 0.0, listOf(42.0, 48.0), 99.0),
        ),
    )

    test("the Driver Station's samples are on the robot's clock, from 10 s before its log until 10 s after it") {
        val robot = logOf(listOf(numbers("Arm", listOf(0.0 to 1.0, 20.0 to 2.0))))
        val both = beside(robot, station, -40.0).both
        both.topic("Driver Station/Trip Time").run { times?.toList() to samples.toList() } shouldBe
            (List(41) { it - 10.0 } to List(41) { (it + 30) / 10.0 })
        both.topic("Driver Station/Trip Time").counts.numbers shouldBe 41
        both.enabledSpans().map { it.span } shouldBe listOf(Span(2.0, 8.0))
    }

    test("a bag in milliseconds gets the Driver Station's times in milliseconds") {
        val text = """{"topics":[{"name":"Time","unit":"ms","attrs":["xaxis"]},{"name":"A","unit":"V","attrs":[]}],"values":[]}""" + "\nTime,A\n0,1\n20000,2\n"
        val robot = BagParser().apply { accept(text.encodeToByteArray()) }.finish()
        beside(robot, station, -40.0).both.topic("Driver Station/Trip Time").times?.toList() shouldBe List(41) { (it - 10) * 1000.0 }
    }

    test("rules get the signals that the robot's log lacks, over its own time; its own signals take precedence") {
        val robot = logOf(listOf(numbers("Battery Voltage", listOf(0.0 to 12.5, 20.0 to 12.0), "V")))
        val forRules = beside(robot, station, -40.0).forRules
        signalTopicsOf(forRules, signals).of("battery").map { it.topic } shouldBe listOf("Battery Voltage")
        signalTopicsOf(forRules, signals).of("trip time").map { it.topic } shouldBe listOf("Driver Station/Trip Time")
        forRules.recording.topics.map { it.name } shouldNotContain "Driver Station/Battery Voltage"
        forRules.xAxis.range shouldBe 0.0..20.0
    }

    test("a topic with a name that the robot's log has is renamed, and the robot's own moments of enabling count") {
        val robot = logOf(
            listOf(flag("DS:enabled", 0.0, listOf(3.0, 9.0), 20.0), numbers("Driver Station/Trip Time", listOf(0.0 to 1.0, 20.0 to 1.0))),
        )
        val both = beside(robot, station, -40.0).both
        both.recording.topics.map { it.name } shouldContain "Driver Station/Trip Time (2)"
        both.enabledSpans().map { it.span } shouldBe listOf(Span(3.0, 9.0))
    }
})
