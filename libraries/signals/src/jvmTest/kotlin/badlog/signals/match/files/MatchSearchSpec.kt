package badlog.signals.match.files

import badlog.core.recording.CellCounts
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
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

/** The files of a match of the day, one of each role. [ahead] has the seconds by which each clock is ahead of the robot's. */
private class Left(val files: List<MatchFile>, val ahead: Map<String, Double>)

private fun file(name: String, role: FileRole, recording: Recording, seconds: Double? = null, error: Double? = null) = MatchFile(name, role, clocked(recording, name), seconds, error)

private fun column(name: String, cells: List<Double>, attributes: List<String> = emptyList(), unit: String = "") = Topic(
    name,
    unit,
    attributes,
    cells.toDoubleArray(),
    TextColumn.EMPTY,
    CellCounts(cells.count { !it.isNaN() }, 0, 0, 0, cells.count { it.isNaN() }, 0),
)

/** A bag of the topics of [log], with a row every [STEP] s. */
private fun bag(log: Recording): Recording {
    val rows = (log.topics.maxOf { checkNotNull(it.times).last() } / STEP).toInt() + 1
    val columns = log.topics.map { topic ->
        val times = checkNotNull(topic.times)
        var at = 0
        val samples = DoubleArray(rows) { row ->
            while (at + 1 < times.size && times[at + 1] <= row * STEP) at++
            topic.samples[at]
        }
        val isFlag = topic.kind == TopicKind.BOOLEAN
        topic.copy(samples = samples, counts = CellCounts(if (isFlag) 0 else rows, 0, if (isFlag) rows else 0, 0, 0, 0), times = null)
    }
    val x = column("Time", List(rows) { it * STEP }, listOf("xaxis"), "s")
    return Recording(RecordingFormat.BAG, null, log.values, listOf(x) + columns, rows, emptyList())
}

/** In s. */
private const val STEP = 0.02

/**
 * Twelve matches, some of them replayed, of two robots, each with a laptop of its own. One is an hour ahead. One robot writes bags, the
 * other WPILOGs. A CAN bus has a log on a clock of its own.
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
            file("robot $index", FileRole.ROBOT, if (robot == 0) bag(own) else own),
            file("station $index", FileRole.STATION, station),
            file("bus $index", FileRole.CAN_BUS, hoot),
        )
        Left(files, mapOf("station $index" to early - before, "bus $index" to early - bus))
    }
}

class MatchSearchSpec : FunSpec({
    test("each match of a day has all of its files on one clock, and none of another match, in any order") {
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
                val others = match.parts.drop(1)
                withClue("run $run, match $index") {
                    others.forEach { (it.file.name in day[index].ahead.keys) shouldBe true }
                    others.forEach { it.seconds shouldBe (day[index].ahead.getValue(it.file.name) plusOrMinus 0.1) }
                }
                if (others.size == 2) complete++
            }
            fun shown(result: FoundMatches) = result.matches.map { one -> one.parts.map { "${it.file.name} ${it.seconds} ${it.why}" } } to result.left.map { it.second }
            shown(matchesOf(all.shuffled(random))) shouldBe shown(found)
        }
        withClue("complete matches") { complete shouldBe matches }
    }

    test("a file that contradicts, or fits two matches alike, is in no match, with the reason in a sentence") {
        fun robot(name: String, number: String) = file(name, FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), null, listOf(Value("Match Number", number))))
        val bus = logOf(listOf(flag("Bus/Robot Enabled", 5.0, PERIODS.map { it + 5 }, 205.0)))
        val other = logOf(listOf(flag("Bus/Robot Enabled", 5.0, PERIODS.map { it + 5 }, 205.0)), null, listOf(Value("Match Number", "9")))
        val found = matchesOf(listOf(robot("a", "1"), robot("b", "2"), file("bus", FileRole.CAN_BUS, bus), file("other", FileRole.CAN_BUS, other)))
        found.matches.map { match -> match.parts.map { it.file.name } } shouldBe listOf(listOf("a"), listOf("b"))
        found.left.first { it.first.name == "bus" }.second shouldContain "a or b"
        found.left.first { it.first.name == "other" }.second shouldContain "fits none"
    }

    test("a log of devices is taken only if the time of day or the number shows the match, not by its edges alone") {
        fun robot(start: String?, number: String?) = file("a", FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), start, listOfNotNull(number?.let { Value("Match Number", it) })))
        fun bus(start: String?, number: String?, name: String = "bus.hoot", role: FileRole = FileRole.CAN_BUS) = file(
            name,
            role,
            logOf(listOf(flag("Bus/Robot Enabled", 5.0, PERIODS.map { it + 5 }, 205.0)), start, listOfNotNull(number?.let { Value("Match Number", it) })),
        )
        fun taken(robot: MatchFile, other: MatchFile) = matchesOf(listOf(other, robot)).run { matches.single().parts.getOrNull(1) to left.singleOrNull()?.second }

        for (role in listOf(FileRole.CAN_BUS, FileRole.MOTORS)) {
            val (none, why) = taken(robot(null, null), bus(null, null, role = role))
            none shouldBe null
            checkNotNull(why) shouldContain "may be of the match of a (4 edges of enabled fit, within 0 ms), but neither the time of day nor the number"
        }
        // Both clocks are known, and an hour and some minutes apart.
        val (other, contradiction) = taken(robot("2026-03-07 10:00:00 UTC", "4"), bus("2026-03-07 11:20:00 UTC", "4"))
        other shouldBe null
        checkNotNull(contradiction) shouldContain "but the time of day contradicts"
        // The first sample of the bus is at 5 s.
        taken(robot("2026-03-07 10:00:00 UTC", null), bus("2026-03-07 10:00:01 UTC", null)).first?.run { seconds to reason } shouldBe (-5.0 to ClockReason.ENABLED)
        taken(robot("2026-03-07 10:00:00 UTC", null), bus("2026-03-07 11:00:01 UTC", null)).first?.seconds shouldBe -5.0
        taken(robot(null, "4"), bus(null, "4")).first?.seconds shouldBe -5.0
        // CTRE's names of files; x of 0 is at this time.
        taken(robot("2024-03-07 10:04:05 UTC", null), bus(null, null, "rio_2024-03-07_10-04-00.hoot")).first?.seconds shouldBe -5.0
        taken(robot("2024-03-07 10:04:05 UTC", null), bus(null, null, "rio_2024-03-07_11-34-00.hoot")).first shouldBe null
        val silent = logOf(listOf(numbers("Bus/Angle", listOf(3.0 to 1.0, 9.0 to 2.0))), "2026-03-07 10:00:20 UTC")
        val (byClock, offered) = taken(robot("2026-03-07 10:00:00 UTC", null), file("bus", FileRole.CAN_BUS, silent))
        byClock shouldBe null
        checkNotNull(offered) shouldContain "by the time of day, which may be seconds off"
    }

    test("a Driver Station's log with a contradictory clock is offered, not taken") {
        fun station(start: String?) = file("station", FileRole.STATION, logOf(listOf(flag("Driver Station/Enabled", 0.0, PERIODS.map { it + 2 }, 205.0)), start))
        val robot = file("a", FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), "2026-03-07 10:00:00 UTC"))
        val other = matchesOf(listOf(robot, station("2026-03-08 10:00:00 UTC")))
        other.matches.single().parts.size shouldBe 1
        other.left.single().second shouldContain "may be of the match of a"
        matchesOf(listOf(robot, station("2026-03-07 10:59:58 UTC"))).matches.single().parts[1].seconds shouldBe -2.0
        matchesOf(listOf(robot, station(null))).matches.single().parts[1].seconds shouldBe -2.0
        matchesOf(listOf(robot)).matches.single().sentences.single() shouldContain "Driver Station's log is missing"
    }

    test("a Driver Station's log of the same number is offered if its time of day shows another play of the match") {
        val number = listOf(Value("Match Number", "5"))
        val replay = file("a", FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), "2026-03-07 11:20:00 UTC", number))
        val first = file("station", FileRole.STATION, logOf(listOf(flag("Driver Station/Enabled", 0.0, PERIODS.map { it + 2 }, 205.0)), "2026-03-07 10:00:00 UTC", number))
        val found = matchesOf(listOf(replay, first))
        found.matches.single().parts.size shouldBe 1
        found.left.single().second shouldContain "but the time of day contradicts"
    }

    test("a Driver Station's log that fits only by when the robot was enabled is taken only if there is one of each, with the reason in a sentence") {
        fun robot(name: String, number: String? = null) = file(name, FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), null, listOfNotNull(number?.let { Value("Match Number", it) })))
        fun station(name: String) = file(name, FileRole.STATION, logOf(listOf(flag("Driver Station/Enabled", 0.0, PERIODS.map { it + 2 }, 205.0)), "2026-03-07 10:00:00 UTC"))
        val match = matchesOf(listOf(robot("a"), station("x"))).matches.single()
        match.parts[1].seconds shouldBe -2.0
        match.sentences.single() shouldContain "x fits by when the robot was enabled, but neither"
        matchesOf(listOf(robot("a", "1"), robot("b", "2"), station("x"))).left.single().second shouldContain "a or b"
    }

    test("other logs are placed beside the log of the robot that shows when it was enabled, whichever has the clock of the match") {
        val camera = file("camera", FileRole.ROBOT, logOf(listOf(numbers("Angle", listOf(0.0 to 1.0, 200.0 to 1.0)))), 0.0)
        val robot = file("robot", FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), "2026-03-07 10:00:00 UTC"), 3.0)
        val station = file("station", FileRole.STATION, logOf(listOf(flag("Driver Station/Enabled", 0.0, PERIODS.map { it + 2 }, 205.0)), "2026-03-07 09:59:58 UTC"))
        val bus = file("bus", FileRole.CAN_BUS, logOf(listOf(flag("Bus/Robot Enabled", 0.0, PERIODS.map { it + 5 }, 205.0)), "2026-03-07 09:59:55 UTC"))
        val match = matchesOf(listOf(robot, bus, station, camera)).matches.single()
        match.parts.map { it.file.name to it.seconds } shouldBe listOf("camera" to 0.0, "robot" to 3.0, "station" to 1.0, "bus" to -2.0)
    }

    test("a log that is not during the robot's log is a problem") {
        val own = file("a.wpilog", FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0))), 0.0)
        val bus = file("rio.hoot", FileRole.CAN_BUS, logOf(listOf(numbers("Bus/Angle", listOf(0.0 to 1.0, 5.0 to 2.0)))), -100.0)
        matchesOf(listOf(own, bus)).matches.single().recording().problems.map { it.kind to it.message } shouldBe
            listOf(ProblemKind.LOG_LEFT_OUT to "No sample of rio.hoot is during the robot's log; check its clock (as stated).")
    }

    test("stated clocks count from the match's clock, whatever the clock of the first robot's log, and all stated files are taken") {
        fun robot(name: String, seconds: Double?) = file(name, FileRole.ROBOT, logOf(listOf(flag("$name/DS:enabled", 0.0, PERIODS, 200.0))), seconds)
        fun station(name: String, seconds: Double?) = file(name, FileRole.STATION, logOf(listOf(flag("Driver Station/Enabled", 0.0, PERIODS, 200.0))), seconds, 0.02)
        fun seconds(vararg files: MatchFile) = matchesOf(files.toList()).matches.single().parts.map { "${it.file.name} ${it.seconds}" }

        seconds(robot("a", 3.0), robot("b", 5.5), station("x", -1.0), station("y", 20.0)) shouldBe listOf("a 0.0", "b 2.5", "x -4.0", "y 17.0")
        // One is the clock of the match.
        seconds(robot("a", 3.0), robot("b", 0.0), station("x", -1.0)) shouldBe listOf("b 0.0", "a 3.0", "x -1.0")
        seconds(robot("a", null), station("x", -1.0)) shouldBe listOf("a 0.0", "x -1.0")
        val bus = file("bus", FileRole.CAN_BUS, logOf(listOf(numbers("Bus/Angle", listOf(0.0 to 1.0)))), 7.0)
        seconds(robot("a", 3.0), bus) shouldBe listOf("a 0.0", "bus 4.0")
        matchesOf(listOf(robot("a", 0.0), station("x", 1.0))).matches.single().parts[1].why shouldBe "as stated, within 20 ms"
    }

    test("two robots in one match stay apart, and two logs of one robot are together") {
        val match = listOf(Value("Match Number", "4"))
        val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0), numbers("Arm", listOf(0.0 to 1.0))), null, match)
        val same = logOf(listOf(flag("DS:enabled", 0.0, PERIODS.map { it + 3 }, 203.0), numbers("Arm", listOf(0.0 to 1.0))), null, match)
        val camera = listOf(flag("DS:enabled", 0.0, PERIODS.map { it + 3 }, 203.0), numbers("Camera", listOf(0.0 to 1.0)))
        val more = logOf(camera, null, match)
        matchesOf(listOf(file("a", FileRole.ROBOT, own), file("b", FileRole.ROBOT, same))).matches.size shouldBe 2
        matchesOf(listOf(file("a", FileRole.ROBOT, own), file("b", FileRole.ROBOT, more))).matches.single().parts[1].seconds shouldBe (-3.0 plusOrMinus 1e-6)
        // One of two robots with one program has logged a topic more.
        val other = logOf(listOf(flag("DS:enabled", 0.0, PERIODS.map { it + 3 }, 203.0), numbers("Arm", listOf(0.0 to 1.0)), numbers("Leg", listOf(0.0 to 1.0))), null, match)
        matchesOf(listOf(file("a", FileRole.ROBOT, own), file("b", FileRole.ROBOT, other))).matches.size shouldBe 2
        // A coprocessor logs a few topics of the robot, too.
        val robot = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)) + List(9) { numbers("Topic $it", listOf(0.0 to 1.0)) }, null, match)
        val few = logOf(listOf(flag("DS:enabled", 0.0, PERIODS.map { it + 3 }, 203.0)) + List(3) { numbers("Topic $it", listOf(0.0 to 1.0)) }, null, match)
        matchesOf(listOf(file("a", FileRole.ROBOT, robot), file("b", FileRole.ROBOT, few))).matches.single().parts.size shouldBe 2
        // Without a number or a time of day, nothing shows that it is the same match.
        matchesOf(listOf(file("a", FileRole.ROBOT, own), file("b", FileRole.ROBOT, logOf(camera)))).matches.size shouldBe 2
    }

    test("all logs of a robot say where another log belongs, so that a replay is offered, and the right log taken beside it") {
        val number = listOf(Value("Match Number", "17"), Value("Match Type", "Qualification"))
        val periods = listOf(10.0, 12.0) + PERIODS
        val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)), "2026-03-07 13:20:00 UTC", number)
        // It has more edges, but no time of day.
        val arm = logOf(listOf(flag("DS:enabled", 0.0, periods, 200.0), numbers("Arm", listOf(0.0 to 1.0))), null, number)
        fun later(name: String, role: FileRole, start: String, values: List<Value> = number) = file(name, role, logOf(listOf(flag("Driver Station/Enabled", 0.0, periods.map { it + 2 }, 205.0)), start, values))
        val robots = listOf(file("robot.wpilog", FileRole.ROBOT, own), file("arm.wpilog", FileRole.ROBOT, arm))
        for (role in listOf(FileRole.STATION, FileRole.CAN_BUS)) {
            val replay = later("replay", role, "2026-03-07 14:59:58 UTC")
            val alone = matchesOf(robots + replay)
            alone.matches.single().parts.map { it.file.name }.toSet() shouldBe setOf("robot.wpilog", "arm.wpilog")
            alone.left.single().second shouldContain "but the time of day contradicts"
            val both = matchesOf(robots + replay + later("first", role, "2026-03-07 13:19:58 UTC", emptyList()))
            both.matches.single().parts.single { it.file.role == role }.run { file.name to seconds } shouldBe ("first" to -2.0)
        }
    }

    test("a log that shows no enabling is put where its battery voltage moves alike") {
        val random = Random(5)
        val match = listOf(Value("Match Number", "4"))
        repeat(20) {
            var volts = 12.6
            val course = List(1500) {
                volts = (volts + random.nextDouble(-0.4, 0.4)).coerceIn(8.0, 12.8)
                volts
            }
            val late = random.nextInt(0, 4000) / 10.0
            val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0), numbers("Battery Voltage", course.mapIndexed { i, v -> i / 10.0 to v }, "V")), null, match)
            val from = random.nextInt(300)
            val part = course.drop(from).take(1000).mapIndexed { i, v -> i / 10.0 + late to v + random.nextDouble(-0.02, 0.02) }
            val bus = logOf(listOf(numbers("Bus/Battery Voltage", part, "V")), null, match)
            val found = matchesOf(listOf(file("a", FileRole.ROBOT, own), file("bus", FileRole.CAN_BUS, bus))).matches.single()
            found.parts[1].run {
                reason shouldBe ClockReason.BATTERY
                seconds shouldBe (from / 10.0 - late plusOrMinus maxOf(0.11, error ?: 0.0))
            }
        }
    }

    test("one recording has the robot's topics as they are, and the others' at their own times on its clock") {
        val number = listOf(Value("Match Number", "4"))
        val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0), numbers("Arm", listOf(0.0 to 1.0, 0.02 to 2.0))), null, number)
        val bus = logOf(listOf(flag("Robot Enabled", 3.0, PERIODS.map { it + 5 }, 205.0), numbers("Arm", List(300) { it + 5.0 to it * 1.0 })), null, number)
        val match = matchesOf(listOf(file("a.wpilog", FileRole.ROBOT, own), file("rio.hoot", FileRole.CAN_BUS, bus))).matches.single()
        val recording = match.recording(listOf("left"))
        recording.topics.map { it.name } shouldContainExactlyInAnyOrder listOf("DS:enabled", "Arm", "rio/Robot Enabled", "rio/Arm")
        recording.topics.first { it.name == "Arm" } shouldBe own.topics[1]
        recording.topics.first { it.name == "rio/Arm" }.run { times?.toList() to samples.size } shouldBe (List(300) { it * 1.0 } to 300)
        recording.values.map { "${it.name}: ${it.text}" } shouldContain
            "Files/rio.hoot: can bus: moved by -5.0 s; 4 edges of enabled fit, within 0 ms; samples outside of the robot's log, which are left out: 1"
        recording.values.last().text shouldBe "left"
        recording.problems.map { it.kind to it.message } shouldBe listOf(ProblemKind.LOG_LEFT_OUT to "left")
        match.recording().problems shouldBe emptyList()
    }

    test("rows that go back in time are sorted, those without a time belong to the row before, and both are reported") {
        val none = Double.NaN
        val x = column("Time", listOf(none, 1.0, 2.0, none, 1.5, 3.0), listOf("xaxis"), "s")
        val vision = Recording(RecordingFormat.BAG, null, emptyList(), listOf(x, column("Angle", listOf(1.0, 2.0, 3.0, 4.0, 5.0, 6.0))), 6, emptyList())
        val own = logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0)))
        val match = matchesOf(listOf(file("a.wpilog", FileRole.ROBOT, own, 0.0), file("eye.bag", FileRole.ROBOT, vision, 10.0))).matches.single()
        val recording = match.recording()
        recording.topics.first { it.name == "eye/Angle" }.run { times?.toList() to samples.toList() } shouldBe
            (listOf(11.0, 11.5, 12.0, 12.0, 13.0) to listOf(2.0, 5.0, 3.0, 4.0, 6.0))
        recording.problems.map { it.kind to it.message } shouldBe listOf(
            ProblemKind.TIMES_SORTED to "The times in eye.bag go backwards; its samples were sorted by time.",
            ProblemKind.X_GAPS to "A row of eye.bag without a time, and without an earlier row with one, cannot be placed.",
        )
    }

    test("a log without samples over time is in no match, even if a clock is stated for it") {
        val own = file("a", FileRole.ROBOT, logOf(listOf(flag("DS:enabled", 0.0, PERIODS, 200.0))), 0.0)
        val list = file("list.csv", FileRole.ROBOT, Recording(RecordingFormat.CSV, null, emptyList(), emptyList(), 0, emptyList()), 1.0)
        val found = matchesOf(listOf(own, list))
        found.matches.single().parts.map { it.file.name } shouldBe listOf("a")
        found.left.map { it.second } shouldBe listOf("list.csv has no samples over time, so it cannot be placed.")
    }

    test("a robot's log that begins before 0 says that all of it is later") {
        val own = logOf(listOf(flag("DS:enabled", -3.0, PERIODS, 200.0)))
        val recording = matchesOf(listOf(file("a.wpilog", FileRole.ROBOT, own))).matches.single().recording()
        recording.values.first { it.name == "Files/a.wpilog" }.text shouldBe
            "robot: the clock of the match, all of which is 3.0 s later, so that no time is before 0"
    }
})
