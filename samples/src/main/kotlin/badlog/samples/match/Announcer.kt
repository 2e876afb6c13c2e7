package badlog.samples.match

import badlog.samples.bag.decimalText
import badlog.samples.robot.Mishaps
import badlog.samples.robot.Mode
import badlog.samples.robot.Robot
import badlog.samples.robot.Superstructure

/** The events in the log of the robot's program. A row holds one event; others wait for the next row. */
class Announcer(private val robot: Robot, private val driver: Driver, private val mishaps: Mishaps) {
    private val waiting = ArrayDeque<String>()
    private var mode = Mode.DISABLED
    private var state = Superstructure.STOWED
    private var wasBrownedOut = false
    private var wasCompressing = false
    private var lastTime = 0.0
    private var scoredAt = 0.0

    /** Returns the next event since the last call; empty if there is none. */
    fun eventAt(time: Double): String {
        if (robot.mode != mode) announceMode()
        if (driver.hasNewOrder) driver.order?.note?.takeIf { it.isNotEmpty() }?.let(waiting::add)
        if (robot.state != state) announceState(time)
        announceBrownout()
        if (robot.pneumatics.isCompressing && !wasCompressing) {
            waiting += "Compressor on at ${decimalText(robot.pneumatics.pressure, 0)} psi"
        }
        wasCompressing = robot.pneumatics.isCompressing
        waiting += mishaps.reportsBetween(lastTime, time).filter { it.isNotEmpty() }
        lastTime = time
        return waiting.removeFirstOrNull() ?: ""
    }

    private fun announceMode() {
        mode = robot.mode
        waiting += when (mode) {
            Mode.DISABLED -> "Disabled"
            Mode.AUTONOMOUS -> "Autonomous enabled: \"Two Piece, Left\", delay 0 s"
            Mode.TELEOP -> "Teleop enabled"
        }
    }

    private fun announceState(time: Double) {
        if (state == Superstructure.SCORING) {
            waiting += if (scoredAt > 0) {
                "Scored, cycle ${decimalText(time - scoredAt, 1)} s"
            } else {
                "Scored the preloaded piece"
            }
            scoredAt = time
        }
        if (state == Superstructure.INTAKING) {
            waiting += if (robot.intake.hasPiece) "Piece in intake" else "WARN: intake closed, no piece"
        }
        state = robot.state
    }

    private fun announceBrownout() {
        val isBrownedOut = robot.roboRio.isBrownedOut
        if (isBrownedOut && !wasBrownedOut) {
            val volts = decimalText(robot.roboRio.batteryVolts, 2)
            val amps = decimalText(robot.power.total, 0)
            waiting += "ERROR: brownout, outputs cut at $volts V, $amps A"
        }
        wasBrownedOut = isBrownedOut
    }
}
