package badlog.viewer.input

import badlog.viewer.choices.range.Viewport
import kotlin.math.abs
import kotlin.math.exp

/** A pressed button of a mouse. */
enum class PointerButton { LEFT, MIDDLE, RIGHT }

/**
 * A pointer on the frame of a plot, or beside it, as a front end reports it. Lengths are in CSS pixels or dp.
 *
 * @property x the distance from the frame's left edge.
 * @property y the distance from the frame's top.
 * @property width the width of the frame.
 * @property height the height of the frame.
 * @property millis the time of any clock, in ms.
 * @property ctrl whether Ctrl is held, or the command key on a Mac.
 * @property button the pressed button of a mouse.
 * @property finger distinguishes fingers; null for a mouse.
 */
class PlotPointer(
    val x: Double,
    val y: Double,
    val width: Double,
    val height: Double,
    val millis: Double,
    val shift: Boolean = false,
    val alt: Boolean = false,
    val ctrl: Boolean = false,
    val button: PointerButton = PointerButton.LEFT,
    val finger: Int? = null,
) {
    /** The x of the pointer as a fraction of the width, from the left. */
    val shareX: Double get() = x / width

    /** The y of the pointer as a fraction of the height, from the top. */
    val shareY: Double get() = y / height
}

/** The effect of a drag over a graph. */
enum class DragKind {
    /** Zooms to the dragged range of x. */
    ZOOM,

    /** Zooms to the dragged range of y, only in its graph. */
    ZOOM_Y,

    /** Selects the dragged range. */
    SELECT,

    /** Moves the graphs. */
    PAN,
    ;

    companion object {
        /** Returns the effect of a drag with the primary button while these keys are held. */
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

/** The wheel over graphs. With Ctrl, or as a pinch on a touch pad, it zooms; sideways or with Shift, it pans. */
class Wheel {
    private var last = Double.NEGATIVE_INFINITY

    /**
     * Returns [viewport] after a turn of the wheel; null if the turn scrolls the page instead.
     *
     * @param right the sideways turn, in CSS pixels or dp.
     * @param down the turn towards the person, in the same pixels.
     * @param x the x under the pointer.
     * @param width the width of the graphs, in the same pixels.
     * @param now the time of any clock, in ms; turns in quick succession are one step of the history.
     */
    fun turned(
        viewport: Viewport,
        right: Double,
        down: Double,
        ctrl: Boolean,
        shift: Boolean,
        x: Double,
        width: Double,
        now: Double,
    ): Viewport? {
        val sideways = if (shift && right == 0.0) down else right
        val pans = !ctrl && viewport.isZoomed && (shift || abs(right) > abs(down))
        if (!ctrl && !pans) return null
        val before = if (now - last > PAUSE) viewport.remembered() else viewport
        last = now
        return if (ctrl) {
            before.scaled(factorOf(down), x)
        } else {
            before.shifted(sideways / width * viewport.visible.width)
        }
    }

    companion object {
        /** The length of one notch in CSS pixels or dp, for a wheel that counts notches. */
        const val NOTCH: Double = 40.0

        /** Returns the factor by which a turn [down] with Ctrl widens the visible range. */
        fun factorOf(down: Double): Double = exp(down.coerceIn(-MAX_TURN, MAX_TURN) * SPEED)

        private const val PAUSE = 500.0
        private const val MAX_TURN = 60.0
        private const val SPEED = 0.008
    }
}

/** The part of the overview that a drag grabs. */
enum class OverviewGrip {
    /** The left edge of the visible range. */
    LEFT,

    /** The right edge of the visible range. */
    RIGHT,

    /** The whole visible range. */
    WINDOW,

    /** None of them: the drag selects a new range. */
    NEW,
    ;

    companion object {
        /** Returns the part at [x] on the overview of [viewport]; one pixel is [pixel] wide in x. */
        fun at(x: Double, viewport: Viewport, pixel: Double): OverviewGrip {
            val visible = viewport.visible
            val reach = EDGE * pixel
            // A quarter at most, so that the middle of a narrow visible range can still be grabbed.
            val inside = minOf(reach, visible.width / 4)
            return when {
                !viewport.isZoomed -> NEW
                x in visible.from - reach..visible.from + inside -> LEFT
                x in visible.to - inside..visible.to + reach -> RIGHT
                x in visible -> WINDOW
                else -> NEW
            }
        }

        private const val EDGE = 6
    }
}
