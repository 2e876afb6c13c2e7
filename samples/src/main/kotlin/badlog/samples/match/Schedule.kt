package badlog.samples.match

import badlog.samples.robot.Mode

/** When the robot is in which mode, in seconds of the recording. */
class Schedule(private val periods: List<Period>, val end: Double) {
    class Period(val mode: Mode, val from: Double, val until: Double)

    fun modeAt(time: Double): Mode = periodAt(time)?.mode ?: Mode.DISABLED

    /** The whole seconds that the field says are left of the period; -1 while disabled. */
    fun secondsLeft(time: Double): Int = periodAt(time)?.let { StrictMath.ceil(it.until - time).toInt() } ?: -1

    private fun periodAt(time: Double) = periods.find { time >= it.from && time < it.until }

    companion object {
        /** A match of 150 s from second 2 of the recording on, with the field's pause of two seconds in it. */
        fun match(secondsAfter: Double) = Schedule(
            listOf(Period(Mode.AUTONOMOUS, 2.0, 17.0), Period(Mode.TELEOP, 19.0, 154.0)),
            154.0 + secondsAfter,
        )

        /** The autonomous period of a match alone, from second 2 of the recording on. */
        fun autonomous(end: Double) = Schedule(listOf(Period(Mode.AUTONOMOUS, 2.0, 17.0)), end)

        /** Practice without a field: enabled at second 1, until someone ends it. */
        fun practice(end: Double) = Schedule(listOf(Period(Mode.TELEOP, 1.0, end)), end)
    }
}
