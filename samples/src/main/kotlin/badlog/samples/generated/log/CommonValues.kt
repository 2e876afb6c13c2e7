package badlog.samples.generated.log

import badlog.samples.generated.robot.Drive
import badlog.samples.generated.robot.MatchRun

/** Returns the console's output since the last loop; null if there is none. */
internal fun consoleText(run: MatchRun): String? {
    val console = run.robot.console
    return if (console.hasText) console.taken().joinToString("\n") else null
}

internal fun matchNumber(run: MatchRun): Long = Math.floorMod(run.plan.seed, 79L) + 1

/** Returns the six axes of the driver's controller; none if it is unplugged. */
internal fun axes(run: MatchRun): DoubleArray {
    val driver = run.robot.driver
    if (!driver.isPluggedIn) return DoubleArray(0)
    // Drivers look at the field from their wall; forward on the stick is negative.
    val isDriven = run.isEnabled && run.phase.ordinal >= 2
    return if (isDriven) doubleArrayOf(-driver.left, -driver.forward, 0.0, 0.0, -driver.turn, 0.0) else DoubleArray(6)
}

/** Returns the speed in m/s and the angle in rad of each module. */
internal fun moduleStates(drive: Drive): DoubleArray = DoubleArray(drive.wheels.size * 2) { index ->
    val wheel = drive.wheels[index / 2]
    if (index % 2 == 0) wheel.measuredSpeed(drive.radius) else wheel.measuredAngle
}

internal fun moduleTargets(drive: Drive): DoubleArray = DoubleArray(drive.wheels.size * 2) { index ->
    val wheel = drive.wheels[index / 2]
    if (index % 2 == 0) wheel.speedTarget else wheel.angleTarget
}
