package badlog.samples.generated.log

import badlog.samples.generated.robot.MatchRun
import badlog.samples.generated.robot.Phase

/**
 * The logger and season of a match that WPILib's own logger records.
 *
 * @property clockSeconds the offset of its clock in s from a 2026 robot's, which starts with the program.
 */
internal enum class LogOrigin(val clockSeconds: Double) {
    /** The naming of the match; for WPILib's logger, a 2026 robot. */
    AS_NAMED(0.0),

    /** A 2027 robot, with a clock that started a day before its program. */
    ROBOT_OF_2027(86_400.0),

    /** The Driver Station of 2027, on a laptop that has been on for five hours. */
    STATION_OF_2027(18_000.0),
}

/**
 * Returns the topics of WPILib's logger on a robot of 2027: a struct with the control word, Telemetry instead of a dashboard, and poses as
 * structs.
 */
internal fun robotTopicsOf2027(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    for (folder in listOf("DS:c", "NT:/DriverStation/C")) {
        structs("${folder}ontrolWord", Struct.CONTROL_WORD) { structWord(run) }
    }
    add("DS:opMode", ValueType.Text, null) { opMode(run) }
    add("systemTime", ValueType.Whole, null, every = CLOCK_LOOPS) { wallMicros(run) }
    add("NT:/Telemetry/Drive/.type", ValueType.Text, null, every = CLOCK_LOOPS) { "Drivetrain" }
    for (topic in wpilibTopics(run)) {
        if (topic.name in REPLACED) continue
        val name = topic.name.replace("NT:/SmartDashboard/", "NT:/Telemetry/").replace("NT:/FMSInfo/", "NT:/DriverStation/")
        if (name == "NT:/Telemetry/Field/Robot") {
            structs(name, Struct.POSE_2D, topic.signal) { run.robot.odometry.run { doubleArrayOf(x, y, heading) } }
        } else {
            topics += LoggedTopic(name, topic.type, topic.unit, topic.attributes, topic.signal, topic.part, topic.everyLoops, topic.read)
        }
    }
}.topics

/** Returns the topics that the Driver Station of 2027 logs in the same match. */
internal fun stationTopicsOf2027(run: MatchRun): List<LoggedTopic> = TopicList().apply {
    val robot = run.robot
    add("systemTime", ValueType.Whole, null, every = CLOCK_LOOPS) { wallMicros(run) }
    encoded("Control/Robot/ControlData", Message.CONTROL_DATA) { whole(1, packedWord(run)).whole(2, 0) }
    encoded("Control/Robot/MatchInfo", Message.MATCH_INFO) { text(1, "SIM").whole(2, 2).whole(3, matchNumber(run)) }
    number("DS:/Dscomm/Status/Power/Battery", null) { robot.measuredVolts }
    truth("DS:/Dscomm/Status/Connection/HasTcpConn", null) { run.isLinked }
    number("DS:/Dscomm/Status/Resources/CPU", null, every = STATION_LOOPS) { robot.computer.load * 100 }
    add("DS:/Dscomm/Status/Resources/CanBusUtilizations", ValueType.Floats, null, every = STATION_LOOPS) {
        doubleArrayOf(robot.bus.utilization * 100, 12.0, 0.0, 0.0, 0.0)
    }
    add("DS:/Dscomm/Status/Timing/LostPackets", ValueType.Whole, null, every = STATION_LOOPS) { 0L }
    encoded("Console/ConsoleLine", Message.CONSOLE_LINE) { text(1, opMode(run)).whole(2, run.phase.ordinal.toLong()) }
}.topics

private fun TopicList.encoded(name: String, message: Message, write: MessageBytes.() -> MessageBytes) =
    add("DS:/Dscomm/$name", ValueType.Encoded(message), null) { MessageBytes().write().bytes }

private fun TopicList.structs(name: String, struct: Struct, word: () -> Long) =
    add(name, ValueType.Structs(struct, isArray = false), null) { word() }

private fun mode(run: MatchRun) = if (run.phase <= Phase.AUTO) AUTONOMOUS else TELEOPERATED

private fun opMode(run: MatchRun) = if (run.phase <= Phase.AUTO) "Two pieces" else "Drive"

private fun structWord(run: MatchRun): Long {
    val flags = bit(0, run.isEnabled) or bit(FMS_BIT, true) or bit(DS_BIT, run.isLinked)
    return opMode(run).hashCode().toLong() and 0xFFFF_FFFFL or (mode(run) shl MODE_SHIFT) or (flags shl FLAGS_SHIFT)
}

private fun packedWord(run: MatchRun): Long =
    bit(0, run.isEnabled) or (mode(run) shl 1) or bit(PACKED_FMS_BIT, true) or bit(PACKED_DS_BIT, run.isLinked)

private fun bit(index: Int, isSet: Boolean) = if (isSet) 1L shl index else 0L

/** Returns the time of the current loop of [run], in µs since 1970. */
private fun wallMicros(run: MatchRun): Long = SEASON_MICROS + Math.floorMod(run.plan.seed, MATCHES) * HOUR_MICROS + (run.now * 1e6).toLong()

/** 2027-03-06 15:00:00 UTC: the first match of the season. Matches are an hour apart. */
private const val SEASON_MICROS = 1_804_345_200_000_000L
private const val HOUR_MICROS = 3_600_000_000L
private const val MATCHES = 997L
private val REPLACED = setOf("DS:enabled", "DS:autonomous", "DS:test", "DS:estop")
private const val AUTONOMOUS = 1L
private const val TELEOPERATED = 2L
private const val MODE_SHIFT = 56
private const val FLAGS_SHIFT = 58
private const val FMS_BIT = 2
private const val DS_BIT = 3
private const val PACKED_FMS_BIT = 4
private const val PACKED_DS_BIT = 5

/** About every 5 s. */
private const val CLOCK_LOOPS = 250
private const val STATION_LOOPS = 5
