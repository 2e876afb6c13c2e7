package badlog.samples

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.Severity
import badlog.samples.fault.Fault
import badlog.samples.fault.FaultyMatch
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import kotlin.math.abs

@Tags("InCheck")
class FaultyMatchSpec : FunSpec({
    fun viewOf(fault: Fault?): LogView {
        val bag = FaultyMatch(5, fault).bag()
        return LogView.of(BagParser().apply { accept(bag) }.finish())
    }

    fun LogView.all(topic: String) = topic(topic).samples.slice(xAxis.positions.indices)

    test("a seed makes the same match each time, and another seed another") {
        FaultyMatch.of(12).bag().contentEquals(FaultyMatch.of(12).bag()) shouldBe true
        FaultyMatch.of(12).bag().contentEquals(FaultyMatch.of(23).bag()) shouldBe false
    }

    test("the seeds include every fault, faint faults, and matches without a fault") {
        val matches = (101..300).map { FaultyMatch.of(it) }
        for (fault in Fault.entries + null) {
            matches.count { it.fault == fault && !it.isFaint } shouldBeGreaterThanOrEqual 12
            matches.count { it.fault == fault && it.isFaint } shouldBeGreaterThanOrEqual 2
        }
    }

    test("a healthy match has no brownout, no error and no loop beyond 40 ms") {
        for (seed in 1..10) {
            val view = LogView.of(BagParser().apply { accept(FaultyMatch(seed, null).bag()) }.finish())
            view.problems.filter { it.severity != Severity.NOTE }.shouldBeEmpty()
            view.all("System/Browned Out").max() shouldBe 0.0
            view.all("System/Battery Voltage").min() shouldBeGreaterThan 7.5
            view.all("System/Loop Time").max() shouldBeLessThan 40.0
            view.events().none { "ERROR" in it.second } shouldBe true
        }
    }

    test("a robot that pushes against a wall stands still, at a current that makes the battery sag") {
        val view = viewOf(Fault.WALL)
        val rows = view.xAxis.positions.indices.filter { row ->
            view.topic("Drivetrain/Left Output").samples[row] > 0.7 && abs(view.topic("Drivetrain/Left Velocity").samples[row]) < 0.15 &&
                view.topic("PDP/Total Current").samples[row] > 150
        }
        rows.size shouldBeGreaterThanOrEqual 20
        rows.minOf { view.topic("System/Battery Voltage").samples[it] } shouldBeLessThan 10.5
    }

    test("a tired battery sags deeper than a healthy one in the same match") {
        viewOf(Fault.TIRED_BATTERY).all("System/Battery Voltage").min() shouldBeLessThan viewOf(null).all("System/Battery Voltage").min() - 1
    }

    test("an unplugged motor draws no current, and its neighbor draws more") {
        val view = viewOf(Fault.UNPLUGGED_MOTOR)
        fun drawn(motor: String) = view.samples("Drivetrain/$motor Current", 120.0, 150.0).average()
        val sides = listOf("Left", "Right")
        sides.map { drawn("$it Follower") < 0.01 && drawn(it) > 1 } shouldContain true
        sides.map { drawn("$it Follower") > 1 } shouldContain true
    }

    test("an encoder without its cable stands still, and its motor does not") {
        val view = viewOf(Fault.PULLED_ENCODER)
        val stopped = listOf("Left", "Right").single { view.samples("Drivetrain/$it Position", 120.0, 150.0).toSet().size == 1 }
        view.samples("Drivetrain/$stopped Output", 120.0, 150.0).max() shouldBeGreaterThan 0.3
    }

    test("errors are counted while the CAN bus is interrupted, and its values stay unchanged") {
        val view = viewOf(Fault.CAN_CUT)
        val errors = view.all("System/CAN Receive Errors")
        val failing = (2 until errors.size - 1).filter { row -> (row - 2..row).all { errors[it + 1] > errors[it] } }
        failing.size shouldBeGreaterThanOrEqual 5
        for (topic in listOf("Drivetrain/Left Position", "Elevator/Position", "PDP/Total Current")) {
            val samples = view.all(topic)
            failing.all { samples[it] == samples[it - 1] } shouldBe true
        }
    }

    test("without its radio a robot is disabled, and receives nothing") {
        val view = viewOf(Fault.RADIO_REBOOT)
        val linked = view.all("System/DS Connected")
        val away = linked.indices.filter { linked[it] == 0.0 }
        view.xAxis.positions[away.last()] - view.xAxis.positions[away.first()] shouldBeGreaterThan 20.0
        val (enabled, tripTime) = view.all("System/Enabled") to view.all("System/Trip Time")
        away.map { enabled[it] } shouldNotContain 1.0
        away.all { tripTime[it].isNaN() } shouldBe true
    }

    test("a crashed program has a log up to the crash, or one from its restart on") {
        val logs = (1..6).map { seed ->
            LogView.of(BagParser().apply { accept(FaultyMatch(seed, Fault.RESTART).bag()) }.finish())
        }
        logs.map { view -> view.all("System/Enabled").first() == 1.0 }.toSet() shouldBe setOf(true, false)
        logs.all { view -> view.all("System/Enabled").let { it.first() == 1.0 || it.last() == 1.0 } } shouldBe true
    }

    test("a loose lead lowers the voltage without more current") {
        val view = viewOf(Fault.LOOSE_LEAD)
        val (volts, amps) = view.all("System/Battery Voltage") to view.all("PDP/Total Current")
        (2 until volts.size).count { volts[it - 2] - volts[it] > 1.5 && amps[it] < amps[it - 2] } shouldBeGreaterThanOrEqual 3
    }

    test("a seized motor draws its maximum current without moving, and blocking vision delays the loop") {
        val seized = viewOf(Fault.SEIZED_MOTOR)
        val (amps, velocity) = seized.all("Elevator/Current") to seized.all("Elevator/Velocity")
        amps.indices.count { amps[it] > 60 && velocity[it] == 0.0 } shouldBeGreaterThanOrEqual 20
        val blocked = viewOf(Fault.SLOW_VISION)
        blocked.all("System/Loop Time").max() shouldBeGreaterThan 120.0
        blocked.all("Vision/Latency").max() shouldBeGreaterThan 60.0
    }
})
