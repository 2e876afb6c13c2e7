package badlog.samples.match

import badlog.samples.robot.Mode

/** The modes of the robot over time. Times are in s from the start of the recording. */
class Schedule(private val periods: List<Period>, val end: Double) {
    class Period(val mode: Mode, val from: Double, val until: Double)

    fun modeAt(time: Double): Mode = periodAt(time)?.mode ?: Mode.DISABLED

    /** Returns the remaining whole seconds of the period according to the field; -1 while disabled. */
    fun secondsLeft(time: Double): Int = periodAt(time)?.let { StrictMath.ceil(it.until - time).toInt() } ?: -1

    private fun periodAt(time: Double) = periods.find { time >= it.from && time < it.until }

    companion object {
        /** Returns a match of 150 s from second 2 of the recording on, including the field's pause of two seconds. */
        fun match(secondsAfter: Double) = Schedule(
            listOf(Period(Mode.AUTONOMOUS, 2.0, 17.0), Period(Mode.TELEOP, 19.0, 154.0)),
            154.0 + secondsAfter,
        )

        /** Returns only the autonomous period of a match, from second 2 of the recording on. */
        fun autonomous(end: Double) = Schedule(listOf(Period(Mode.AUTONOMOUS, 2.0, 17.0)), end)

        /** Returns practice without a field: enabled from second 1 until [end]. */
        fun practice(end: Double) = Schedule(listOf(Period(Mode.TELEOP, 1.0, end)), end)
    }
}
