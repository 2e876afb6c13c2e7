package badlog.signals.match.files

import badlog.core.recording.Topic
import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.FoundStation
import badlog.signals.clock.clocked
import badlog.signals.clock.flag
import badlog.signals.clock.logOf
import badlog.signals.clock.numbers
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

private val PERIODS = listOf(20.0, 35.3, 37.1, 172.2)

class StationClaimSpec : FunSpec({
    fun course(random: Random): List<Double> {
        var volts = 12.6
        return List(2000) { volts.also { volts = (volts + random.nextDouble(-0.4, 0.4)).coerceIn(8.0, 12.8) } }
    }

    fun battery(name: String, course: List<Double>, late: Double, random: Random = Random(1)) = numbers(name, course.mapIndexed { i, volts -> i / 10.0 + late to volts + random.nextDouble(-0.02, 0.02) }, "V")

    /** A log of a robot with a clock that is [late], which has a [battery] or not. */
    fun robot(late: Double, battery: List<Double>? = null, periods: List<Double> = PERIODS, length: Double = 200.0): ClockedLog {
        val enabled = flag("DS:enabled", late, periods.map { it + late }, length + late)
        return clocked(logOf(listOfNotNull<Topic>(enabled, battery?.let { battery("Battery Voltage", it, late) })))
    }

    fun station(battery: List<Double>, late: Double = 0.0) = clocked(
        logOf(listOf(flag("Driver Station/Enabled", late, PERIODS.map { it + late }, 205.0 + late), battery("Driver Station/Battery Voltage", battery, late))),
    )

    fun claim(robot: ClockedLog, station: ClockedLog, vararg others: ClockedLog): Boolean? {
        val fit = checkNotNull(ClockFit.ofEdges(station.edges, robot.edges))
        return FoundStation(Unit, station, fit).claimOf(robot, others.toList()).isOwn
    }

    test("of two robots in a match, the one whose battery moves alike has the log, and never both") {
        val random = Random(17)
        repeat(maxOf(3, PropertyTesting.defaultIterationCount / 20)) {
            val (one, two) = course(random) to course(random)
            val (early, late) = random.nextDouble(0.0, 30.0) to random.nextDouble(40.0, 90.0)
            val station = station(one, random.nextDouble(0.0, 20.0))
            claim(robot(early, one), station, robot(late, two)) shouldBe true
            claim(robot(late, two), station, robot(early, one)) shouldBe false
        }
    }

    test("without a battery that shows it, the log is of neither") {
        val random = Random(4)
        val (one, two, other) = List(3) { course(random) }
        claim(robot(5.0), station(one), robot(50.0)) shouldBe null
        claim(robot(5.0), station(one), robot(50.0, one)) shouldBe null
        claim(robot(5.0, two), station(one), robot(50.0, other)) shouldBe null
    }

    test("another log of the same robot, a copy, or one of another match does not contest it") {
        val one = course(Random(9))
        val own = robot(5.0)
        claim(own, station(one)) shouldBe true
        claim(own, station(one), robot(5.0)) shouldBe true
        // Its program was restarted after the autonomous period.
        val restarted = clocked(logOf(listOf(flag("DS:enabled", 6.0, PERIODS.drop(2).map { it - 30 }, 170.0))))
        claim(robot(5.0, periods = PERIODS.take(2), length = 36.0), station(one), restarted) shouldBe true
        val camera = clocked(logOf(listOf(flag("Camera/Robot Enabled", 50.0, PERIODS.map { it + 50 }, 250.0), numbers("Camera/Angle", listOf(60.0 to 1.0)))))
        claim(own, station(one), camera) shouldBe true
        claim(own, station(one), robot(50.0, periods = listOf(3.0, 9.0, 40.0, 41.5))) shouldBe true
        claim(robot(5.0, one), station(one), robot(50.0, one)) shouldBe true
    }
})
