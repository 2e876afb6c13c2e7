package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.json.quotedJson
import badlog.rules.standing.UNCOUNTED_TRUST

/** The built-in rules with silent ones heard as those on trial: slices and counts look at all of them. */
internal val HEARD_RULES: RuleSet by lazy { builtInRulesFromToml { name, hash -> maxOf(countedTrust(name, hash), UNCOUNTED_TRUST) } }

/**
 * A match of [seconds] at 50 rows a second, made of functions of time. It is a healthy one, in which [number], [flag] and [event] plant
 * faults. Names come from different libraries; units are only in names.
 */
internal class TestMatch(private val seconds: Int = 40) {
    private val cells = LinkedHashMap<String, (time: Double, row: Int) -> String>()
    private val units = HashMap<String, String>()

    init {
        flag("/DriverStation/Enabled") { it in ENABLED }
        flag("/DriverStation/Autonomous") { it < AUTONOMOUS_END }
        number("/DriverStation/MatchTime") { if (it < AUTONOMOUS_END) 15 - it else 160 - it }
        flag("/DriverStation/DSAttached") { it > 1 }
        flag("/SystemStats/BrownedOut") { false }
        number("/SystemStats/BatteryVoltage") { 12.6 - 0.015 * load(it) }
        number("/SystemStats/BatteryCurrent") { 0.4 }
        for (i in 0..3) number("/PowerDistribution/ChannelCurrent[$i]") { load(it) / 4 }
        number("/SystemStats/3v3Rail/CurrentFaults") { 0.0 }
        number("/SystemStats/CANBus/Utilization") { 0.55 + 0.02 * wave(it) }
        number("/SystemStats/CANBus/ReceiveErrorCount") { 0.0 }
        number("/SystemStats/CANBus/OffCount") { 0.0 }
        number("/SystemStats/CPUTempCelsius") { 50.0 }
        number("/RealOutputs/LoggedRobot/FullCycleMS") { if (it < 1) 300.0 else 9 + wave(it) }
        number("/RealOutputs/LoggedRobot/GCTimeMS") { 0.0 }
        number("/DSLog/TripTimeMS") { 8.0 }
        number("/DSLog/PacketLoss") { 0.001 }
        number("/DSLog/CPUUtilization") { 0.5 }
        number("/DSLog/WifiDb") { -45.0 }
        for (side in listOf("Left", "Right")) {
            number("Drive/$side/DutyCycle") { output(it) }
            number("Drive/$side/AppliedVolts") { 12 * output(it) }
            number("Drive/$side/VelocityRadPerSec") { 50 * output(it) }
            number("Drive/$side/SupplyCurrentAmps") { load(it) / 4 }
            number("Drive/$side/PositionRad") { position(it) }
            number("Drive/$side/TempCelsius") { 40 + it / 4 }
            flag("Drive/$side/Connected") { it > 0.5 }
            flag("Drive/$side/StickyFault_BootDuringEnable") { false }
        }
        number("Elevator/Setpoint") { setpoint(it) }
        number("Elevator/Height") { height(it) }
        number("Elevator/Output") { (setpoint(it) - height(it)).coerceIn(-0.9, 0.9) }
        number("Odometry/Robot/translation/x") { 5 + wave(it / 10) }
        number("Odometry/Robot/translation/y") { 3 + wave(it / 7) }
        number("Odometry/TrajectorySetpoint/translation/x") { 5 + wave(it / 10) }
        number("Odometry/TrajectorySetpoint/translation/y") { 3.1 + wave(it / 7) }
        number("DS:joystick0/axes[0]") { if (it in ENABLED) wave(it) else 0.01 }
        flag("DS:joystick0/buttons[0]") { it in ENABLED && wave(it) > 0.9 }
        number("Vision/Latency") { 30 + 5 * wave(it) }
        number("limelight/hb") { (it * 30).toInt().toDouble() }
        number("Gyro/Angle") { 90 + 0.001 * TestMatch.wave(it * 40) + if (it in ENABLED) 60 * wave(it / 2 - 2) else 0.0 }
        // A cylinder takes its air at once, and the compressor runs for a second.
        number("Pneumatics/Pressure") { 106 + 4 * (it % 10).coerceAtMost(1.0) }
        flag("Pneumatics/Compressor On") { it.toInt() % 10 == 0 }
        number("System/Free Memory MB") { 60.0 }
        number("System/Free Disk MB") { 300.0 }
        event("messages", 2.0 to "Robot program starting", 5.0 to "Vision target lost", 20.0 to "0 errors so far")
    }

    fun number(name: String, unit: String = "ul", at: (Double) -> Double) = cell(name, unit) { time, _ -> at(time).toString() }

    fun flag(name: String, at: (Double) -> Boolean) = cell(name, "ul") { time, _ -> at(time).toString() }

    /** [name] has the cells that [at] returns, empty ones for none. */
    fun cells(name: String, at: (Double) -> String) = cell(name, "ul") { time, _ -> at(time) }

    /** [name] has [text] all the time. */
    fun state(name: String, text: String) = cell(name, "ul") { _, _ -> text }

    fun event(name: String, vararg events: Pair<Double, String>) = cell(name, "ul") { _, row ->
        events.filter { (it.first * ROWS).toInt() == row }.joinToString("; ") { it.second }
    }

    /** [name] is unchanged until [from], and has the values of [at] from then on. */
    fun from(from: Double, name: String, at: (Double) -> String) {
        val before = cells.getValue(name)
        cell(name, units.getValue(name)) { time, row -> if (time < from) before(time, row) else at(time) }
    }

    /** [name] is unchanged outside of [span], and has the values of [at] within it. */
    fun within(span: ClosedRange<Double>, name: String, at: (Double) -> String) {
        val others = cells.getValue(name)
        cell(name, units.getValue(name)) { time, row -> if (time in span) at(time) else others(time, row) }
    }

    fun without(name: String) = cells.remove(name)

    private fun cell(name: String, unit: String, at: (Double, Int) -> String) {
        cells[name] = at
        units[name] = unit
    }

    /** The match as a log. [clock] returns the time of each row. */
    fun view(clock: (Double) -> Double? = { it }): LogView {
        val names = listOf("Time") + cells.keys
        val header = names.joinToString(",", "{\"topics\":[", "],\"values\":[]}") { name ->
            val attributes = if (name == "Time") {
                "\"xaxis\""
            } else if (name == "messages") {
                "\"log\""
            } else {
                ""
            }
            "{\"name\":${quotedJson(name)},\"unit\":\"${if (name == "Time") "s" else units[name]}\",\"attrs\":[$attributes]}"
        }
        val text = StringBuilder(header).append('\n').append(names.joinToString(",")).append('\n')
        for (row in 0 until seconds * ROWS) {
            val time = row.toDouble() / ROWS
            val shown = clock(time) ?: continue
            text.append(shown)
            for (cell in cells.values) text.append(',').append(cell(time, row))
            text.append('\n')
        }
        return LogView.of(BagParser().apply { accept(text.toString().encodeToByteArray()) }.finish())
    }

    fun findings(rules: RuleSet = HEARD_RULES): List<Finding> = rules.over(view(), "test.bag").findings

    companion object {
        const val ROWS = 50
        const val AUTONOMOUS_END = 15.0
        val ENABLED = 4.0..38.0

        fun wave(time: Double): Double = kotlin.math.sin(2 * kotlin.math.PI * time / 3)

        fun output(time: Double): Double = if (time in ENABLED) 0.6 * wave(time) else 0.0

        fun load(time: Double): Double = 4 + if (time in ENABLED) 120 * wave(time) * wave(time) else 0.0

        fun position(time: Double): Double = if (time in ENABLED) 25 * (1 - kotlin.math.cos(2 * kotlin.math.PI * time / 3)) else 0.0

        fun setpoint(time: Double): Double = (time / 8).toInt() % 3 * 0.5

        /** Half a second behind the setpoint. */
        fun height(time: Double): Double = setpoint(time - 0.5) + 0.002 * wave(time)
    }
}
