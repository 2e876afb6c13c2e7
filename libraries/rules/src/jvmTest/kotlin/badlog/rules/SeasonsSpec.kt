package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsAutonomous
import badlog.core.bag.RecordingParser
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.stationStartIn
import badlog.samples.generated.GeneratedMatch
import badlog.samples.generated.MatchGenerator
import badlog.samples.generated.fault.FAULTS
import badlog.samples.generated.fault.Naming
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.StationOverlay
import badlog.signals.clock.StationSearch
import badlog.signals.pose.posesOf
import badlog.signals.signalTopicsOf
import badlog.signals.withSignals
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.round

/** The offset of the clock of a robot of 2027: it began a day before. */
private const val LATER = 86_400.0

/** By how much the clock of its Driver Station differs from that. */
private const val STATION_OFFSET = 86_400.0 - 18_000.0

/** A loop of the robot, in s. */
private const val LOOP = 0.021

private val SIGNALS = RuleSet.BUILT_IN.signals

private fun viewOf(match: GeneratedMatch): LogView {
    val parser = RecordingParser(LOG_FORMATS, match.bytes.size.toLong())
    parser.accept(match.bytes)
    return LogView.of(parser.finish()).withSignals(SIGNALS, match.fileName)
}

/** The text of a finding, and its time in the clock of 2026. */
private class TimedText(val text: String, val times: List<Double>)

private fun findingsIn(view: LogView, later: Double) = RuleSet.BUILT_IN.over(view, "a.wpilog").findings.map { finding ->
    // Each text has the times of its own clock.
    val text = finding.text.replace("NT:/SmartDashboard/", "NT:/Telemetry/").replace(Regex("[0-9][0-9.,:]*"), "#")
    TimedText("${finding.rule} ${finding.severity} $text", finding.spans.flatMap { listOf(it.from - later, it.to - later) })
}.sortedWith(compareBy({ it.text }, { it.times.firstOrNull() ?: 0.0 }))

@Tags("InCheck")
class SeasonsSpec : FunSpec({
    val generator = MatchGenerator(2027)
    val matches = listOf(generator.healthy(Naming.WPILIB, 0), generator.healthy(Naming.WPILIB, 2)) +
        FAULTS.filterIndexed { index, _ -> index % 8 == 0 }.map { generator.faulty(Naming.WPILIB, it, 1.0) }

    test("the same match logged as in 2026 and as in 2027 has the same findings, phases and paths, though the clock began a day before") {
        for (match in matches) {
            withClue(match.name) {
                val before = viewOf(match)
                val after = viewOf(MatchGenerator.asIn2027(match))
                after.recording.problems shouldBe before.recording.problems
                after.knowsAutonomous shouldBe true
                fun phases(view: LogView, later: Double) = view.enabledSpans().map { Triple(round((it.span.from - later) * 1000), round((it.span.to - later) * 1000), it.isAutonomous) }
                phases(after, LATER) shouldContainExactly phases(before, 0.0)
                after.enabledSpans().map { it.opMode }.distinct() shouldContainExactly listOf("Two pieces", "Drive")
                val findings = findingsIn(before, 0.0)
                val findingsLater = findingsIn(after, LATER)
                findingsLater.map { it.text } shouldContainExactly findings.map { it.text }
                for ((own, other) in findingsLater zip findings) {
                    own.times.size shouldBe other.times.size
                    // A day later, rounding of times is 16 times as coarse. A condition that just holds long enough may begin a loop later.
                    for ((time, wanted) in own.times zip other.times) time shouldBe (wanted plusOrMinus LOOP)
                }
                fun path(view: LogView) = posesOf(view.recording.topics).first { "Field/Robot" in it.name }.let { pose ->
                    view.recording.topics.first { it.name == pose.x }.samples.toList()
                }
                path(after) shouldBe path(before)
                after.title shouldBe before.title
            }
        }
    }

    test("the Driver Station's log of 2027 is found beside its robot's by the time of day, and put on its clock by the phases") {
        val match = matches.first()
        val after = MatchGenerator.asIn2027(match)
        val robot = ClockedLog(after.fileName, viewOf(after).recording, SIGNALS)
        val other = MatchGenerator.stationIn2027(generator.healthy(Naming.WPILIB, 5))
        val own = MatchGenerator.stationIn2027(match)
        stationStartIn(own.bytes.copyOf(1 shl 16)).shouldNotBeNull()
        val found = StationSearch<GeneratedMatch>(robot, { stationStartIn(it.bytes.copyOf(1 shl 16)) }) {
            ClockedLog(it.fileName, viewOf(it).recording, SIGNALS)
        }.over(listOf(other, own)).shouldNotBeNull()
        found.log.name shouldBe own.name
        found.fit.seconds shouldBe (STATION_OFFSET plusOrMinus 0.05)
        val both = StationOverlay(viewOf(after), found.station, found.fit, SIGNALS)
        signalTopicsOf(both.forRules, SIGNALS).of("CAN load of a bus").shouldNotBeEmpty()
        both.both.enabledSpans() shouldBe viewOf(after).enabledSpans()
        checkNotNull(both.both.xAxis.range).start shouldBe (LATER + 60 plusOrMinus 200.0)
    }

    test("a full CAN bus is found whichever of the five it is") {
        val after = MatchGenerator.stationIn2027(matches.first())
        val rules = RuleSet.BUILT_IN
        rules.over(viewOf(after), "a.wpilog").findings.none { it.rule == "One CAN bus full" } shouldBe true
        val view = viewOf(after)
        val bus = view.recording.topics.first { it.name.endsWith("CanBusUtilizations[3]") }
        val full = bus.copy(samples = DoubleArray(bus.size) { if (it in 350..450) 95.0 else 20.0 })
        val changed = LogView.of(view.recording.copy(topics = view.recording.topics.map { if (it === bus) full else it }))
        rules.over(changed, "a.wpilog").findings.single { it.rule == "One CAN bus full" }.text.let { "[3]" in it } shouldBe true
    }
})
