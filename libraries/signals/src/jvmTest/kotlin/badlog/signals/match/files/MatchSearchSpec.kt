package badlog.signals.match.files

import badlog.core.recording.Recording
import badlog.core.recording.Value
import badlog.core.text.wallTimeText
import badlog.signals.clock.clocked
import badlog.signals.clock.flag
import badlog.signals.clock.logOf
import badlog.signals.clock.numbers
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import kotlin.math.abs
import kotlin.random.Random

private val PERIODS = listOf(20.0, 35.3, 37.1, 172.2)

/** What a match of the day left: the file of each role, and how far the clock of each is ahead of the robot's. */
private class Left(val files: List<MatchFile>, val ahead: Map<String, Double>)

private fun file(name: String, role: FileRole, recording: Recording, seconds: Double? = null) = MatchFile(name, role, clocked(recording, name), seconds)

/**
 * Twelve matches, some of them replayed, of two robots, each with a laptop of its own, of which one is an hour ahead. A robot writes a bag;
 * a CAN bus has a log on a clock of its own, and motor controllers count from the start of the program.
 */
private fun day(random: Random): List<Left> {
    val numbers = (1..12).flatMap { if (random.nextInt(6) == 0) listOf(it, it) else listOf(it) }
    val begins = ArrayList<Double>()
    return numbers.mapIndexed { index, number ->
        var now = (begins.lastOrNull() ?: 1_772_895_845.0) + random.nextInt(420, 700)
        while (begins.any { abs(now - it - 3600) < 20 }) now += 45
        begins += now
        val robot = random.nextInt(2)
        val periods = PERIODS.map { it + random.nextDouble(-0.02, 0.02) }
        val values = listOf(Value("Match Number", "$number"), Value("Match Type", "Qualification"))
        val early = random.nextDouble(10.0, 90.0)
        val battery = { from: Double ->
            var volts = 12.5
            numbers("Battery Voltage", List(2000) { i -> (i / 10.0 + from) to volts.also { volts = 12.5 - (volts * 7919 + i * i) % 1.5 } }, "V")
        }
        val own = logOf(listOf(flag("DS:enabled", 0.0, periods.map { it + early }, 200 + early), battery(early)), wallTimeText((now - early) * 1e6), values)
        val before = random.nextDouble(1.0, 15.0)
        val ahead = if (robot == 1) 3600.0 else 0.0
        val enabled = flag("Driver Station/Enabled", 0.0, periods.map { it + before + random.nextDouble(-0.02, 0.02) }, 200 + before)
        val station = logOf(listOf(enabled), wallTimeText((now - before + ahead) * 1e6), if (random.nextBoolean()) values else emptyList())
        val bus = random.nextDouble(1.0, 500.0)
        val hoot = logOf(
            listOf(flag("Bus/Robot Enabled", bus, periods.map { it + bus }, 200 + bus)),
            wallTimeText(now * 1e6),
            if (random.nextBoolean()) values else emptyList(),
        )
        val files = listOf(
            file("robot $index", FileRole.ROBOT, own),
            file("station $index", FileRole.STATION, station),
            file("bus $index", FileRole.CAN_BUS, hoot),
            MatchFile("r${index}_Q$number.mp4", FileRole.VIDEO, null),
        )
        Left(files, mapOf("station $index" to early - before, "bus $index" to early - bus))
    }
}

class MatchSearchSpec : FunSpec({
    test("of a day of matches, each has its files, on one clock, and none of another, whatever the order") {
        val random = Random(9041)
        var complete = 0
        var matches = 0
        repeat(maxOf(3, PropertyTesting.defaultIterationCount / 50)) { run ->
            val day = day(random)
            val all = day.flatMap { it.files }
            val found = matchesOf(all.shuffled(random))
            found.matches.size shouldBe day.size
            for (match in found.matches) {
                matches++
                val index = match.robot.name.removePrefix("robot ").toInt()
                val others = match.parts.drop(1).filter { it.file.role != FileRole.VIDEO }
                withClue("run $run, match $index") {
                    others.forEach { (it.file.name in day[index].ahead.keys) shouldBe true }
                    others.forEach { it.seconds shouldBe (day[index].ahead.getValue(it.file.name) plusOrMinus 0.1) }
                }
                if (others.size == 2) complete++
            }
            fun shown(result: FoundMatches) = result.matches.map { one -> one.parts.map { "${it.file.name} ${it.seconds} ${it.why}" } } to result.left.map { it.second }
            shown(matchesOf(all.shuffled(random))) shouldBe shown(found)
        }
        withClue("$complete of $matches") { (complete > matches * 0.95) shouldBe true }
    }

    test("a file that contradicts, or fits two matches alike, is in none, and a sentence says so") {
        fun robot(name: String, number: String) = file(name, FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), null, listOf(Value("Match Number", number))))
        val bus = logOf(listOf(flag("Bus/Robot Enabled", 5.0, PERIODS.map { it + 5 }, 205.0)))
        val other = logOf(listOf(flag("Bus/Robot Enabled", 5.0, PERIODS.map { it + 5 }, 205.0)), null, listOf(Value("Match Number", "9")))
        val found = matchesOf(listOf(robot("a", "1"), robot("b", "2"), file("bus", FileRole.CAN_BUS, bus), file("other", FileRole.CAN_BUS, other)))
        found.matches.map { match -> match.parts.map { it.file.name } } shouldBe listOf(listOf("a"), listOf("b"))
        found.left.first { it.first.name == "bus" }.second shouldContain "a or b"
        found.left.first { it.first.name == "other" }.second shouldContain "fits none"
        val alone = matchesOf(listOf(robot("a", "1"), file("bus", FileRole.CAN_BUS, bus))).matches.single()
        alone.parts[1].run { seconds to reason } shouldBe (-5.0 to ClockReason.ENABLED)
        alone.sentences.single() shouldContain "Driver Station's log is missing"
    }

    test("two robots in one match stay apart, and two logs of one robot are together") {
        val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0), numbers("Arm", listOf(0.0 to 1.0))))
        val same = logOf(listOf(flag("DS:enabled", 0.0, PERIODS.map { it + 3 }, 203.0), numbers("Arm", listOf(0.0 to 1.0))))
        val more = logOf(listOf(flag("DS:enabled", 0.0, PERIODS.map { it + 3 }, 203.0), numbers("Camera", listOf(0.0 to 1.0))))
        matchesOf(listOf(file("a", FileRole.ROBOT, own), file("b", FileRole.ROBOT, same))).matches.size shouldBe 2
        matchesOf(listOf(file("a", FileRole.ROBOT, own), file("b", FileRole.ROBOT, more))).matches.single().parts[1].seconds shouldBe (-3.0 plusOrMinus 1e-6)
    }

    test("a log that shows no enabling is put where its battery voltage moves alike") {
        val random = Random(5)
        repeat(20) {
            var volts = 12.6
            val course = List(1500) { volts = (volts + random.nextDouble(-0.4, 0.4)).coerceIn(8.0, 12.8); volts }
            val late = random.nextInt(0, 4000) / 10.0
            val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0), numbers("Battery Voltage", course.mapIndexed { i, v -> i / 10.0 to v }, "V")))
            val from = random.nextInt(300)
            val part = course.drop(from).take(1000).mapIndexed { i, v -> i / 10.0 + late to v + random.nextDouble(-0.02, 0.02) }
            val bus = logOf(listOf(numbers("Bus/Battery Voltage", part, "V")))
            val match = matchesOf(listOf(file("a", FileRole.ROBOT, own), file("bus", FileRole.CAN_BUS, bus))).matches.single()
            match.parts[1].run {
                reason shouldBe ClockReason.BATTERY
                seconds shouldBe (from / 10.0 - late plusOrMinus maxOf(0.11, error ?: 0.0))
            }
        }
    }

    test("one recording has the robot's topics as they are, and the others' at their own times on its clock") {
        val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0), numbers("Arm", listOf(0.0 to 1.0, 0.02 to 2.0))))
        val bus = logOf(listOf(flag("Robot Enabled", 5.0, PERIODS.map { it + 5 }, 205.0), numbers("Arm", List(300) { it + 5.0 to it * 1.0 })))
        val match = matchesOf(listOf(file("a.wpilog", FileRole.ROBOT, own), file("rio.hoot", FileRole.CAN_BUS, bus))).matches.single()
        val recording = match.recording(listOf("left"))
        recording.topics.map { it.name } shouldContainExactlyInAnyOrder listOf("DS:enabled", "Arm", "rio/Robot Enabled", "rio/Arm")
        recording.topics.first { it.name == "Arm" } shouldBe own.topics[1]
        recording.topics.first { it.name == "rio/Arm" }.run { times?.toList() to samples.size } shouldBe (List(300) { it * 1.0 } to 300)
        recording.values.map { "${it.name}: ${it.text}" } shouldContain "Files/rio.hoot: can bus: moved by -5.0 s; 4 edges of enabled fit, within 0 ms"
        recording.values.last().text shouldBe "left"
    }
})
