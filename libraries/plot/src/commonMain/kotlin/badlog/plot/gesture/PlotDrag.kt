package badlog.plot.gesture

/** What a drag over a graph does. */
public enum class DragKind {
    /** Shows what it covers. */
    ZOOM,

    /** Shows what it covers of y, in its graph only. */
    ZOOM_Y,

    /** Marks what it covers. */
    SELECT,

    /** Moves the graphs along. */
    PAN,
    ;

    public companion object {
        /** What a drag with the first button does while these keys are held. */
        public fun of(shift: Boolean, alt: Boolean): DragKind = when {
            shift -> PAN
            alt -> ZOOM_Y
            else -> ZOOM
        }

        /** A pointer that has moved by fewer CSS pixels or dp has not begun a drag. */
        public const val MIN_DISTANCE: Double = 4.0
    }
}

/** Recognizes the second of two quick clicks. */
public class DoubleClick {
    private var millis = Double.NEGATIVE_INFINITY
    private var place = 0.0

    /** Whether a click at [x], in CSS pixels or dp, and at the time [now] of any clock is a second one. */
    public fun isSecond(x: Double, now: Double): Boolean {
        val isSecond = now - millis < PAUSE && x - place < REACH && place - x < REACH
        millis = if (isSecond) Double.NEGATIVE_INFINITY else now
        place = x
        return isSecond
    }

    private companion object {
        const val PAUSE = 350.0

        // As a finger needs.
        const val REACH = 24.0
    }
}
