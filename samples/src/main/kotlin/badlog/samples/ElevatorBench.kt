package badlog.samples

import badlog.samples.bag.BagLog
import badlog.samples.bag.NumberText
import badlog.samples.robot.Elevator

/** Returns a plain CSV file of the elevator on the bench. Its gain is too high at first, then suitable. */
fun elevatorBench(): ByteArray {
    var elevator = Elevator(gain = TOO_MUCH)
    var time = 0.0
    val log = BagLog(NumberText.SENSOR_DECIMALS, emptyList())
    log.number("Time", "s", 2) { time }
    log.number("Setpoint", "m", 4) { elevator.profile.position }
    log.number("Position", "m", 4) { elevator.position }
    log.number("Output", "ul", 3) { elevator.output }
    log.number("Current", "A", 1) { elevator.windingAmps(BENCH_VOLTS) }
    log.writeTitles()
    for (loop in 0 until LOOPS) {
        if (loop == LOOPS / 2) elevator = Elevator()
        time = loop * PERIOD
        elevator.control(enabled = true, PERIOD)
        elevator.profile.goal = if (loop % (LOOPS / 2) in UP) 1.0 else 0.0
        log.log()
        repeat(STEPS) { elevator.move(BENCH_VOLTS, PERIOD / STEPS) }
    }
    return log.bytes()
}

private const val TOO_MUCH = 40.0
private const val BENCH_VOLTS = 12.4
private const val PERIOD = 0.02
private const val STEPS = 5
private const val LOOPS = 500
private val UP = 25..139
