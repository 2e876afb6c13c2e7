package badlog.rules

import kotlin.math.abs
import kotlin.math.sign

private const val TRIP = "/DSLog/TripTimeMS"
private const val LOSS = "/DSLog/PacketLoss"
private const val LEFT = "Drive/Left/PositionRad"

/** For each rule, a match as near as possible to one of [PLANTED] in which it must be silent. */
internal val NEAR_MISSES: Map<String, TestMatch.() -> Unit> = mapOf(
    "Browned out" to { within(20.0..20.1, BATTERY) { "6.8" } },
    "Below the brownout voltage" to {
        number("/SystemStats/BrownoutVoltage") { 7.5 }
        within(20.0..20.1, BATTERY) { "7.6" }
    },
    "Low battery" to { within(20.0..20.05, BATTERY) { "6.4" } },
    "Weak battery" to { within(20.0..20.4, BATTERY) { "8.4" } },
    "Battery not charged" to { number(BATTERY) { 12.3 - 0.015 * TestMatch.load(it) } },
    "Bad battery contact" to { within(20.4..20.5, BATTERY) { (11.9 - 0.015 * TestMatch.load(it)).toString() } },
    "High battery resistance" to { number(BATTERY) { 12.8 - 0.043 * TestMatch.load(it) } },
    "Raised battery resistance" to { number(BATTERY) { 12.8 - 0.03 * TestMatch.load(it) } },
    "Current too long" to { within(20.0..21.9, CHANNEL) { "70" } },
    "High current" to { within(20.0..20.9, CHANNEL) { "55" } },
    // A motor starts, and rests after that.
    // The other channels rest, too.
    "Channel rests alone" to {
        from(25.0, CHANNEL) { if (it < 25.5) "45" else "0" }
        for (i in listOf(0, 1, 3)) from(27.5, "/PowerDistribution/ChannelCurrent[$i]") { "4" }
    },
    // Its other faults are none of breakers, and one breaker was open all along.
    // Another fault stays; a breaker's bit that falls back at once was misread.
    "Breaker open" to {
        number("/PowerDistribution/Faults") {
            if (it < 20) {
                16.0
            } else if (it < 20.4) {
                24.0
            } else {
                16.0 + (1 shl 25)
            }
        }
    },
    // A good battery bears a sprint.
    "Too much at once" to {
        from(20.0, CHANNEL) { if (it < 22) "250" else "3" }
        within(20.0..22.0, BATTERY) { "7.8" }
    },
    "Main breaker" to { within(20.0..21.9, CHANNEL) { "250" } },
    "High total current" to { within(20.0..24.8, CHANNEL) { "190" } },
    "Rail fault" to { number("/SystemStats/3v3Rail/CurrentFaults") { if (it < 20) 3.0 else 2.0 } },
    // The other motor jumps from 0 to 109 °C, which no motor does.
    "Motor too hot" to {
        number("Drive/Left/TempCelsius") { 49 + it }
        number("Drive/Right/TempCelsius") { if (it < 17) 0.0 else 109.0 }
    },
    "Motor hot" to { number("Drive/Left/TempCelsius") { 41.5 + it } },
    "Motor stalled" to {
        within(20.0..20.5, "Drive/Left/VelocityRadPerSec") { "0" }
        within(20.0..20.5, "Drive/Left/DutyCycle") { "0.5" }
        within(20.0..20.5, "Drive/Left/SupplyCurrentAmps") { "45" }
    },
    "Output saturated" to { within(20.0..20.8, "Elevator/Output") { "1.0" } },
    "Output without voltage" to { within(20.0..20.15, "Drive/Left/AppliedVolts") { "0" } },
    "Motor fault" to { flag("Drive/Left/StickyFault_BootDuringEnable") { true } },
    "Device lost" to { flag("Drive/Left/Connected") { it > 0.5 && it !in 20.0..20.4 } },
    "Linked motor without current" to { from(20.0, "Drive/Right/SupplyCurrentAmps") { "0.5" } },
    "Linked motors unequal" to { number("Drive/Right/SupplyCurrentAmps") { 0.6 * TestMatch.load(it) / 4 } },
    "Linked speeds differ" to { from(20.0, "Drive/Right/VelocityRadPerSec") { (42 * TestMatch.output(it)).toString() } },
    // It draws as much as a blocked motor.
    "Encoder stopped" to {
        from(20.0, LEFT) { "10" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "20" }
    },
    // It draws less than a motor that is blocked.
    "Still at stall current" to {
        from(20.0, "Drive/Left/VelocityRadPerSec") { "0" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "12" }
    },
    // An arm is held up.
    "Motor does not turn" to {
        number("Phoenix6/TalonFX-5/DutyCycle") { if (it in 20.0..32.0) 0.3 else 0.3 * TestMatch.output(it) }
        number("Phoenix6/TalonFX-5/Velocity") { if (it in 20.0..32.0) 0.0 else 60 * TestMatch.output(it) }
        number("Phoenix6/TalonFX-5/SupplyCurrent") { if (it in 20.0..32.0) 22.0 else 3.0 }
    },
    "Side stands still" to { within(20.0..20.15, LEFT) { "10" } },
    "Device without values" to {
        for (id in 1..3) number("Phoenix6/TalonFX-$id/DutyCycle") { 0.0 }
        within(20.0..20.2, "Phoenix6/TalonFX-2/DutyCycle") { "" }
    },
    "Values frozen" to { within(20.0..20.8, LEFT) { TestMatch.position(20.0).toString() } },
    "Limit switch contradicted" to { flag("Elevator/Bottom Limit") { maxOf(TestMatch.height(it), TestMatch.height(it - 0.2)) < 0.01 } },
    "Encoder frozen" to { arm { 90 * TestMatch.wave((if (it in 20.0..20.1) 20.0 else it) / 2) } },
    "Motor and mechanism disagree" to { arm { 90 * TestMatch.wave(it / 2) + if (it < 20) 0.0 else 0.4 * (it - 20) } },
    "Output without effect" to {
        from(16.0, "Elevator/Height") { (0.75 * TestMatch.height(it)).toString() }
        from(16.0, "Elevator/Output") { "0.5" }
    },
    // The limit is at the setpoint.
    // At the lower end, the switch closes a little early.
    "Stopped by a limit" to {
        number("Elevator/Height") { maxOf(TestMatch.height(it), 0.1) }
        flag("Elevator/Upper Limit") { it in 17.0..24.0 }
        flag("Elevator/Lower Limit") { TestMatch.height(it) < 0.1 }
    },
    "Overshoot" to { number("Elevator/Height") { TestMatch.height(it) + if (it % 8 in 0.5..1.2) 0.05 * step(it) else 0.0 } },
    "Away from its setpoint" to {
        from(16.0, "Elevator/Height") { (0.95 * TestMatch.height(it)).toString() }
        from(16.0, "Elevator/Output") { "0.2" }
    },
    // Its load pulls it down, too.
    "Moves harder" to { lift(load = 20.0) { if (it < 15) 4.0 else 5.0 } },
    "Position oscillates" to { number("Elevator/Height") { TestMatch.height(it) + 0.015 * TestMatch.wave(it * 6) } },
    "Speed oscillates" to { shooter { 4000 + 40 * TestMatch.wave(it * 4) } },
    "Speed not reached" to { shooter { 3900 + TestMatch.wave(it) } },
    // It holds two game pieces, one after the other.
    "Driven without moving" to {
        number("Intake/Velocity RPM") { if (it in 20.0..23.0 || it in 27.0..30.0) 0.0 else 1000 + TestMatch.wave(it) }
        number("Intake/Current") { if (it in 20.0..23.0 || it in 27.0..30.0) 40.0 + TestMatch.wave(it) else 8.0 }
    },
    // It rests at a stop, and its motor pushes against that.
    "Position stands still" to {
        number("Wrist/Position") { if (it < 24) TestMatch.position(it) else 12.5 }
        number("Wrist/Output") { if (it < 24) TestMatch.output(it) else -abs(TestMatch.output(it)) }
        // A motor without power.
        number("Elbow/Position") { if (it < 24) TestMatch.position(it) else 12.5 }
        number("Elbow/Output") { TestMatch.output(it) }
        number("Elbow/Current") { if (it < 24) TestMatch.load(it) else 0.0 }
    },
    "Module does not turn" to { swerve(angle = { module, angle -> if (module == 2) angle - 0.09 else angle }) },
    "Module lags" to { swerve(angle = { module, angle -> (if (module == 2) 0.947 else 0.95) * angle }) },
    "Module draws less current" to {
        swerve()
        for (i in 0..3) number("Drive/Module$i/DriveCurrentAmps") { if (i == 2) 18.0 else 20.0 }
    },
    "Channel lost its share" to {
        swerve()
        from(15.0, CHANNEL) { (TestMatch.load(it) / 5).toString() }
    },
    "Side needs more output" to { number("Drive/Left/AppliedVolts") { 12 * TestMatch.output(it) + 0.2 * sign(TestMatch.output(it)) } },
    "Heading jumped" to { from(20.0, "Gyro/Angle") { (100 + 60 * TestMatch.wave(it / 2 - 2)).toString() } },
    "Vision jumps" to {
        number("Vision/Robot/translation/x") { 5 + TestMatch.wave(it / 10) + if ((it * TestMatch.ROWS).toInt() % 400 == 100) 0.5 else 0.0 }
        number("Vision/Robot/translation/y") { 3 + TestMatch.wave(it / 7) }
    },
    // A driver set the heading anew, which jumps.
    "Heading leaves the camera" to {
        number("Vision/Pose[0]") { 5.0 }
        number("Vision/Pose[1]") { 3.0 }
        number("Vision/Pose[2]") { 40 * TestMatch.wave(it / 9) }
        number("Gyro/Angle") { 40 * TestMatch.wave(it / 9) + if (it < 22) 10.0 else 33.0 }
    },
    "Encoders disagree" to { from(20.0, "Drive/Right/PositionRad") { (0.95 * TestMatch.position(it)).toString() } },
    "Pose jumped" to { from(20.0, "Odometry/Robot/translation/x") { (5.45 + TestMatch.wave(it / 10)).toString() } },
    "Left the plan" to { from(10.0, "Odometry/TrajectorySetpoint/translation/x") { (5.3 + TestMatch.wave(it / 10)).toString() } },
    "Gyro drifts" to {
        flag("/DriverStation/Enabled") { it in 15.0..38.0 }
        number("Gyro/Angle") { if (it < 15) 10 + 0.1 * it else 11.5 + 20 * TestMatch.wave(it - 15) }
    },
    "No new pictures" to { within(20.0..23.5, "limelight/hb") { "1000" } },
    "Loop blocked" to { within(20.0..20.05, LOOP_TIME) { "95" } },
    "Loop and vision late together" to { within(20.0..20.05, LOOP_TIME) { "240" } },
    // Garbage is collected twice.
    "Loop overrun" to { for (at in 20..25) within(at.toDouble()..at + 0.03, LOOP_TIME) { "70" } },
    "Slow loops" to { within(20.0..21.4, LOOP_TIME) { "30" } },
    "Long garbage collection" to { within(20.0..20.05, "/RealOutputs/LoggedRobot/GCTimeMS") { "90" } },
    "Frequent garbage collection" to {
        within(22.0..22.05, "/RealOutputs/LoggedRobot/GCTimeMS") { "25" }
        within(24.0..24.05, "/RealOutputs/LoggedRobot/GCTimeMS") { "25" }
    },
    "CPU overloaded" to { from(5.0, "/DSLog/CPUUtilization") { "0.8" } },
    "CPU busy" to { within(20.0..24.5, "/DSLog/CPUUtilization") { "0.97" } },
    "CPU hot" to { from(20.0, "/SystemStats/CPUTempCelsius") { "74" } },
    "Memory nearly full" to { number("System/Free Memory MB") { 60 - 1.2 * it } },
    "Disk nearly full" to { number("System/Free Disk MB") { 91 - it } },
    "CAN bus full" to { within(20.0..20.05, "/SystemStats/CANBus/Utilization") { "1.0" } },
    "CAN utilization high" to { within(20.0..20.8, "/SystemStats/CANBus/Utilization") { "0.88" } },
    "One CAN bus full" to { number("DS:/Dscomm/Status/Resources/CanBusUtilizations[3]") { if (it < 20) 20.0 else 89.0 } },
    "CAN bus off" to { number("/SystemStats/CANBus/OffCount") { 1.0 } },
    "CAN errors" to {
        number("/SystemStats/CANBus/ReceiveErrorCount") {
            if (it < 2) {
                0.0
            } else if (it < 20) {
                12.0
            } else if (it < 25) {
                14.0
            } else {
                15.0
            }
        }
    },
    "Radio lost power" to {
        within(19.7..20.0, BATTERY) { "8.4" }
        flag("/DriverStation/DSAttached") { it > 1 && it !in 20.0..22.0 }
        flag("/DriverStation/Enabled") { it in TestMatch.ENABLED && it !in 20.0..22.0 }
    },
    "Link lost" to { flag("/DriverStation/DSAttached") { it > 1 && it !in 2.5..3.0 && it !in 20.0..20.9 } },
    "Packets very late" to { within(20.0..20.4, TRIP) { "150" } },
    "Packets late" to { within(20.0..20.8, TRIP) { "60" } },
    "Many packets lost" to { within(20.0..20.8, LOSS) { "0.3" } },
    "Packets lost" to { within(20.0..20.8, LOSS) { "0.05" } },
    "Very weak radio signal" to { from(20.0, "/DSLog/WifiDb") { "-69" } },
    "Weak radio signal" to { from(20.0, "/DSLog/WifiDb") { "-59" } },
    "Late pictures" to { within(20.0..20.8, "Vision/Latency") { "180" } },
    "Low air pressure" to { from(20.0, "Pneumatics/Pressure") { "61" } },
    "Stored air falls" to {
        number("Pneumatics/Pressure") { 110 - 0.2 * it }
        flag("Pneumatics/Compressor On") { false }
    },
    "Compressor without effect" to {
        number("Pneumatics/Pressure") { 60 + it }
        flag("Pneumatics/Compressor On") { true }
    },
    "Controller unplugged" to { within(20.0..20.4, "DS:joystick0/axes[0]") { "" } },
    "Button held while disabled" to {
        flag("/DriverStation/Enabled") { it in 10.0..38.0 }
        flag("DS:joystick0/buttons[0]") { it < 4 }
    },
    "Restarted in the match" to {
        flag("/DriverStation/Enabled") { it < 38 }
        number("/DriverStation/MatchTime") { 140 - it }
    },
    // A practice without a field.
    "Log begins in teleop" to {
        flag("/DriverStation/Enabled") { it < 38 }
        flag("/DriverStation/Autonomous") { false }
        flag("/DriverStation/FMSAttached") { false }
    },
    // Whoever deploys code before a match restarts it.
    "Code restarted" to { number("Robot/Uptime") { if (it < 2) 400 + it else it - 2 } },
    "Ended in the match" to { flag("/DriverStation/Enabled") { it in 4.0..39.5 } },
    "Loop overruns reported" to { event("messages", *Array(19) { 5.0 + it to "Loop time of 0.02s overrun" }) },
    "Vision in the loop" to { event("messages", *Array(9) { 5.0 + it to "Loop time of 0.02s overrun Vision.periodic(): 0.005000s" }) },
    "Code crashed" to { event("messages", 20.0 to "Caught an exception: java.lang.NullPointerException") },
    "Error logged" to { event("messages", 20.0 to "no errors", 21.0 to "Brownouts: 0") },
    "Sensor lost" to { within(20.0..20.9, LEFT) { "" } },
    "Flat sensor" to { number("Gyro/Angle") { if (it < 20) 180.0 else 180.001 } },
)
