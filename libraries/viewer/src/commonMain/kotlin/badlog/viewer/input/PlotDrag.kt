package badlog.viewer.input

/** What a drag over a graph does. */
enum class DragKind {
    /** Zooms to what it covers. */
    ZOOM,

    /** Zooms to what it covers of y, only in its graph. */
    ZOOM_Y,

    /** Selects what it covers. */
    SELECT,

    /** Moves the graphs. */
    PAN,
    ;

    companion object {
        /** Returns what a drag with the primary button does while these keys are held. */
        fun of(shift: Boolean, alt: Boolean): DragKind = when {
            shift -> PAN
            alt -> ZOOM_Y
            else -> ZOOM
        }

        /** The minimum distance of a drag, in CSS pixels or dp. */
        const val MIN_DISTANCE: Double = 4.0
    }
}

/** Recognizes the second of two quick clicks. */
class DoubleClick {
    private var millis = Double.NEGATIVE_INFINITY
    private var place = 0.0

    /** Returns whether a click at [x], in CSS pixels or dp, at the time [now] of any clock, is the second of a double click. */
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
