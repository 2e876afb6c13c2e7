package badlog.rules

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.sign

/** Each rule, and what to plant in a match so that the rule finds it. */
internal val PLANTED: Map<String, TestMatch.() -> Unit> = mapOf(
    "Browned out" to { flag("/SystemStats/BrownedOut") { it in 20.0..20.3 } },
    "Below the brownout voltage" to {
        number("/SystemStats/BrownoutVoltage") { 7.5 }
        from(20.0, BATTERY) { if (it < 20.1) "7.2" else "12" }
    },
    "Low battery" to { from(20.0, BATTERY) { if (it < 20.5) "6.4" else "12" } },
    "Weak battery" to { from(20.0, BATTERY) { if (it < 21.0) "8.4" else "12" } },
    "Battery not charged" to { number(BATTERY) { 12.2 - 0.015 * TestMatch.load(it) } },
    "Bad battery contact" to { from(20.4, BATTERY) { if (it < 20.5) "8" else (12.6 - 0.015 * TestMatch.load(it)).toString() } },
    "High battery resistance" to { number(BATTERY) { 12.8 - 0.055 * TestMatch.load(it) } },
    "Raised battery resistance" to { number(BATTERY) { 12.8 - 0.036 * TestMatch.load(it) } },
    "Current too long" to { from(20.0, CHANNEL) { if (it < 22.5) "70" else "3" } },
    "High current" to { from(20.0, CHANNEL) { if (it < 21.5) "55" else "3" } },
    // It pulled less than most breakers stand.
    "Channel rests alone" to { from(25.0, CHANNEL) { if (it < 25.5) "45" else "0" } },
    "Breaker open" to { number("/PowerDistribution/Faults") { if (it < 20) 0.0 else 16.0 } },
    "Too much at once" to {
        from(20.0, CHANNEL) { if (it < 22) "250" else "3" }
        within(20.0..22.0, BATTERY) { "7.2" }
    },
    "Main breaker" to { from(20.0, CHANNEL) { if (it < 22.5) "250" else "3" } },
    "High total current" to { from(20.0, CHANNEL) { if (it < 25.5) "190" else "3" } },
    "Rail fault" to { number("/SystemStats/3v3Rail/CurrentFaults") { if (it < 20) 2.0 else 3.0 } },
    "Motor too hot" to { number("Drive/Left/TempCelsius") { 60 + it } },
    "Motor hot" to { number("Drive/Left/TempCelsius") { 45 + it } },
    "Motor stalled" to {
        from(20.0, "Drive/Left/VelocityRadPerSec") { "0" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "45" }
    },
    "Output saturated" to { from(20.0, "Elevator/Output") { "1.0" } },
    "Output without voltage" to { from(20.0, "Drive/Left/AppliedVolts") { "0" } },
    "Motor fault" to { flag("Drive/Left/StickyFault_BootDuringEnable") { it > 20 } },
    "Device lost" to { flag("Drive/Left/Connected") { it in 0.5..20.0 } },
    "Linked motor without current" to { from(20.0, "Drive/Right/SupplyCurrentAmps") { "0" } },
    "Linked motors unequal" to { number("Drive/Right/SupplyCurrentAmps") { TestMatch.load(it) / 12 } },
    "Linked speeds differ" to { from(20.0, "Drive/Right/VelocityRadPerSec") { (30 * TestMatch.output(it)).toString() } },
    "Encoder stopped" to {
        from(20.0, "Drive/Left/PositionRad") { "10" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "8" }
    },
    "Still at stall current" to {
        from(20.0, "Drive/Left/VelocityRadPerSec") { "0" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "25" }
    },
    "Motor does not turn" to {
        number("Phoenix6/TalonFX-5/DutyCycle") { if (it in 20.0..32.0) 0.55 else 0.3 * TestMatch.output(it) }
        number("Phoenix6/TalonFX-5/Velocity") { if (it in 20.0..32.0) 0.0 else 60 * TestMatch.output(it) }
        number("Phoenix6/TalonFX-5/SupplyCurrent") { if (it in 20.0..32.0) 22.0 else 3.0 }
    },
    "Side stands still" to { from(20.0, "Drive/Left/PositionRad") { "10" } },
    "Device without values" to {
        for (id in 1..3) number("Phoenix6/TalonFX-$id/DutyCycle") { 0.0 }
        from(20.0, "Phoenix6/TalonFX-2/DutyCycle") { "" }
    },
    "Values frozen" to {
        within(20.0..20.8, "Drive/Left/PositionRad") { TestMatch.position(20.0).toString() }
        within(20.0..20.8, "Drive/Left/VelocityRadPerSec") { "20" }
    },
    "Limit switch contradicted" to { flag("Elevator/Bottom Limit") { it < 30 } },
    "Encoder frozen" to { arm { if (it < 20) 90 * TestMatch.wave(it / 2) else 45.0 } },
    "Motor and mechanism disagree" to { arm { 90 * TestMatch.wave(it / 2) + if (it < 20) 0.0 else 3 * (it - 20) } },
    "Output without effect" to {
        from(16.0, "Elevator/Height") { (0.75 * TestMatch.height(it)).toString() }
        from(16.0, "Elevator/Output") { "0.9" }
    },
    "Stopped by a limit" to {
        number("Elevator/Height") { minOf(TestMatch.height(it), 0.85) }
        flag("Elevator/Upper Limit") { it in 17.0..24.0 }
    },
    "Overshoot" to { number("Elevator/Height") { TestMatch.height(it) + if (it % 8 in 0.5..1.2) 0.3 * step(it) else 0.0 } },
    "Away from its setpoint" to {
        from(16.0, "Elevator/Height") { (0.75 * TestMatch.height(it)).toString() }
        from(16.0, "Elevator/Output") { "0.2" }
    },
    "Moves harder" to { lift(load = 3.0) { if (it < 15) 4.0 else 12.0 } },
    "Position oscillates" to { number("Elevator/Height") { TestMatch.height(it) + 0.05 * TestMatch.wave(it * 6) } },
    "Speed oscillates" to { shooter { 4000 + 200 * TestMatch.wave(it * 4) } },
    "Speed not reached" to { shooter { 3500 + TestMatch.wave(it) } },
    "Driven without moving" to {
        number("Intake/Velocity RPM") { if (it in 20.0..22.0) 0.0 else 1000 + TestMatch.wave(it) }
        number("Intake/Current") { if (it in 20.0..22.0) 40.0 else 8.0 }
    },
    "Position stands still" to {
        number("Wrist/Position") { if (it < 24) TestMatch.position(it) else 12.5 }
        number("Wrist/Output") { TestMatch.output(it) }
    },
    "Module does not turn" to { swerve(angle = { module, angle -> if (module == 2) 0.0 else angle }) },
    "Module lags" to { swerve(angle = { module, angle -> (if (module == 2) 0.93 else 0.95) * angle }) },
    "Module draws less current" to {
        swerve()
        for (i in 0..3) number("Drive/Module$i/DriveCurrentAmps") { if (i == 2) 10.0 else 20.0 }
    },
    "Channel lost its share" to {
        swerve()
        from(15.0, CHANNEL) { (TestMatch.load(it) / 10).toString() }
    },
    "Side needs more output" to { number("Drive/Left/AppliedVolts") { 12 * TestMatch.output(it) + 1.2 * sign(TestMatch.output(it)) } },
    "Heading jumped" to { from(20.0, "Gyro/Angle") { (200 + 60 * TestMatch.wave(it / 2 - 2)).toString() } },
    "Vision jumps" to {
        number("Vision/Robot/translation/x") { 5 + TestMatch.wave(it / 10) + if ((it * TestMatch.ROWS).toInt() % 400 == 100) 3.0 else 0.0 }
        number("Vision/Robot/translation/y") { 3 + TestMatch.wave(it / 7) }
    },
    "Heading leaves the camera" to {
        number("Vision/Pose[0]") { 5.0 }
        number("Vision/Pose[1]") { 3.0 }
        number("Vision/Pose[2]") { 40 * TestMatch.wave(it / 9) }
        number("Gyro/Angle") { 40 * TestMatch.wave(it / 9) + 10.0 + if (it < 10) 0.0 else 0.6 * (it - 10) }
    },
    "Encoders disagree" to { from(20.0, "Drive/Right/PositionRad") { "10" } },
    "Pose jumped" to { from(20.0, "Odometry/Robot/translation/x") { (6 + TestMatch.wave(it / 10)).toString() } },
    "Left the plan" to { from(10.0, "Odometry/TrajectorySetpoint/translation/x") { (5 + TestMatch.wave(it / 10) + (it - 10) / 2).toString() } },
    "Gyro drifts" to {
        flag("/DriverStation/Enabled") { it in 15.0..38.0 }
        number("Gyro/Angle") { if (it < 15) 10 + 0.4 * it else 16 + 20 * TestMatch.wave(it - 15) }
    },
    "No new pictures" to { from(20.0, "limelight/hb") { "1000" } },
    "Loop blocked" to { from(20.0, LOOP_TIME) { if (it < 20.05) "240" else "9" } },
    "Loop and vision late together" to {
        from(20.0, LOOP_TIME) { if (it < 20.05) "240" else "9" }
        from(20.0, "Vision/Latency") { if (it < 20.1) "220" else "30" }
    },
    "Loop overrun" to { from(20.0, LOOP_TIME) { if (it < 20.4) "60" else "9" } },
    "Slow loops" to { from(20.0, LOOP_TIME) { if (it < 24) "30" else "9" } },
    "Long garbage collection" to { from(20.0, "/RealOutputs/LoggedRobot/GCTimeMS") { if (it < 20.05) "120" else "0" } },
    "Frequent garbage collection" to { from(20.0, "/RealOutputs/LoggedRobot/GCTimeMS") { if (it.toInt() % 2 == 0) "25" else "0" } },
    "CPU overloaded" to {
        from(5.0, "/DSLog/CPUUtilization") { "0.8" }
        from(5.0, LOOP_TIME) { "30" }
    },
    "CPU busy" to { from(20.0, "/DSLog/CPUUtilization") { "0.97" } },
    "CPU hot" to { from(20.0, "/SystemStats/CPUTempCelsius") { "78" } },
    "Memory nearly full" to { number("System/Free Memory MB") { 60 - 1.6 * it } },
    "Disk nearly full" to { number("System/Free Disk MB") { 60 - it } },
    "CAN bus full" to { from(20.0, "/SystemStats/CANBus/Utilization") { "0.97" } },
    "CAN utilization high" to { from(20.0, "/SystemStats/CANBus/Utilization") { "0.88" } },
    "One CAN bus full" to { number("DS:/Dscomm/Status/Resources/CanBusUtilizations[3]") { if (it < 20) 20.0 else 97.0 } },
    "CAN bus off" to { number("/SystemStats/CANBus/OffCount") { if (it < 20) 0.0 else 1.0 } },
    "CAN errors" to { number("/SystemStats/CANBus/ReceiveErrorCount") { floor((it - 20).coerceIn(0.0, 3.0) * 5) } },
    "Radio lost power" to {
        from(19.7, BATTERY) { if (it < 20) "6.9" else "12" }
        flag("/DriverStation/DSAttached") { it > 1 && it !in 20.0..22.0 }
        flag("/DriverStation/Enabled") { it in TestMatch.ENABLED && it !in 20.0..22.0 }
    },
    "Link lost" to {
        flag("/DriverStation/DSAttached") { it > 1 && it !in 20.0..22.0 }
        flag("/DriverStation/Enabled") { it in TestMatch.ENABLED && it !in 20.0..22.0 }
    },
    "Packets very late" to { from(20.0, "/DSLog/TripTimeMS") { "150" } },
    "Packets late" to { from(20.0, "/DSLog/TripTimeMS") { "60" } },
    "Many packets lost" to { from(20.0, "/DSLog/PacketLoss") { "0.3" } },
    "Packets lost" to { from(20.0, "/DSLog/PacketLoss") { "0.05" } },
    "Very weak radio signal" to { from(20.0, "/DSLog/WifiDb") { "-75" } },
    "Weak radio signal" to { from(20.0, "/DSLog/WifiDb") { "-65" } },
    "Late pictures" to { from(20.0, "Vision/Latency") { "180" } },
    "Low air pressure" to { from(20.0, "Pneumatics/Pressure") { "50" } },
    "Stored air falls" to {
        number("Pneumatics/Pressure") { 110 - it }
        flag("Pneumatics/Compressor On") { false }
    },
    "Compressor without effect" to {
        number("Pneumatics/Pressure") { 100.0 }
        flag("Pneumatics/Compressor On") { true }
    },
    "Controller unplugged" to { from(20.0, "DS:joystick0/axes[0]") { "" } },
    "Button held while disabled" to {
        flag("/DriverStation/Enabled") { it in 10.0..38.0 }
        flag("DS:joystick0/buttons[0]") { it < 12 }
    },
    "Restarted in the match" to {
        flag("/DriverStation/Enabled") { it < 38 }
        number("/DriverStation/MatchTime") { 90 - it }
    },
    "Log begins in teleop" to {
        // With the match time, it is known that the program had restarted.
        without("/DriverStation/MatchTime")
        flag("/DriverStation/Enabled") { it < 38 }
        flag("/DriverStation/Autonomous") { false }
        flag("/DriverStation/FMSAttached") { true }
    },
    "Code restarted" to { number("Robot/Uptime") { if (it < 20) 400 + it else it - 20 } },
    "Ended in the match" to { flag("/DriverStation/Enabled") { it > 4 } },
    "Loop overruns reported" to { event("messages", *Array(25) { 5.0 + it to "Loop time of 0.02s overrun" }) },
    "Vision in the loop" to { event("messages", *Array(9) { 5.0 + it to "Loop time of 0.02s overrun Vision.periodic(): 0.050000s" }) },
    "Code crashed" to { event("messages", 20.0 to "Unhandled exception: java.lang.NullPointerException") },
    "Error logged" to { event("messages", 20.0 to "ERROR: arm encoder") },
    "Sensor lost" to { from(20.0, "Drive/Left/PositionRad") { "" } },
    "Flat sensor" to { number("Gyro/Angle") { 180.0 } },
)

/** An arm with a sensor of its own, which reads [angle] in degrees. */
internal fun TestMatch.arm(angle: (Double) -> Double) {
    number("Arm/Motor Position (rot)") { 25 * TestMatch.wave(it / 2) }
    number("Arm/Angle (deg)", at = angle)
}

internal fun TestMatch.shooter(rpm: (Double) -> Double) {
    number("Shooter/Setpoint RPM") { 4000.0 }
    number("Shooter/Velocity RPM", at = rpm)
}

/** A lift that goes up and down. From 15 s on, its motor also carries a [load]; it overcomes a [friction], in A. */
internal fun TestMatch.lift(load: Double, friction: (Double) -> Double) {
    for (name in listOf("Lift/Setpoint", "Lift/Height")) number(name) { 0.5 + 0.4 * TestMatch.wave(it) }
    number("Lift/Current Amps") { (if (it < 15) 3.0 else load) - 5 * TestMatch.wave(it) + friction(it) * sign(TestMatch.wave(it + 0.75)) }
}

/** Four modules with targets that they follow, but for what [angle] and [speed] make of them. */
internal fun TestMatch.swerve(angle: (Int, Double) -> Double = { _, angle -> angle }, speed: (Int, Double) -> Double = { _, _ -> 2.0 }) {
    for (i in 0..3) {
        number("Swerve/Measured[$i]/speed") { speed(i, it) }
        number("Swerve/Measured[$i]/angle/value") { angle(i, TestMatch.wave(it / 4)) }
        number("Swerve/Setpoints[$i]/speed") { speed(i, it) }
        number("Swerve/Setpoints[$i]/angle/value") { TestMatch.wave(it / 4) }
    }
}

/** The step that the elevator's setpoint made last. */
internal fun step(time: Double) = TestMatch.setpoint(time) - TestMatch.setpoint(time - 8)

internal const val BATTERY = "/SystemStats/BatteryVoltage"
internal const val CHANNEL = "/PowerDistribution/ChannelCurrent[2]"
internal const val LOOP_TIME = "/RealOutputs/LoggedRobot/FullCycleMS"
