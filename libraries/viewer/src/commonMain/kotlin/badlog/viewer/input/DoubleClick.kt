package badlog.viewer.input

/** Recognizes the second of two quick clicks. */
class DoubleClick {
    private var millis = Double.NEGATIVE_INFINITY
    private var place = 0.0

    /** Returns whether a click at [x], in CSS pixels or dp, is the second of a double click. [now] is the time of any clock, in ms. */
    fun isSecond(x: Double, now: Double): Boolean {
        val isSecond = now - millis < PAUSE && x - place < REACH && place - x < REACH
        millis = if (isSecond) Double.NEGATIVE_INFINITY else now
        place = x
        return isSecond
    }

    private companion object {
        const val PAUSE = 350.0

        // Large enough for a finger.
        const val REACH = 24.0
    }
}
