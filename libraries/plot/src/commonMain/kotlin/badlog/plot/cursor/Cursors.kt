package badlog.plot.cursor

import badlog.analysis.Span
import kotlin.math.abs

/**
 * The places on x at which a person reads values. Immutable; each transition returns a new one.
 *
 * @property pinned the first cursor, A, which stays where it was put; null for none.
 * @property second the second one, B, with which A is compared; null for none, and whenever there is no A.
 * @property hover the pointer's current or last place; null for nowhere.
 */
public data class Cursors(public val pinned: Double? = null, public val second: Double? = null, public val hover: Double? = null) {
    /** Where values are read: at A, or otherwise under the pointer; null for nowhere. */
    public val x: Double? get() = pinned ?: hover

    /** Where a person looks for marks: under the pointer, or otherwise at A; null for nowhere. */
    public val pointed: Double? get() = hover ?: pinned

    /** Whether A stays where it is when the pointer moves. */
    public val isPinned: Boolean get() = pinned != null

    /** From A to B, or from B to A if B comes first; null unless both exist at different places. */
    public val between: Span?
        get() = if (pinned == null || second == null || pinned == second) null else Span(minOf(pinned, second), maxOf(pinned, second))

    /** Moves the pointer to [x]; neither A nor B moves. */
    public fun hovering(x: Double): Cursors = copy(hover = x)

    /** Removes the pointer, which left the graphs. If nothing is pinned, values are still read at its last place. */
    public fun left(): Cursors = if (isPinned) copy(hover = null) else this

    /** Pins A at [x]. */
    public fun pinnedAt(x: Double): Cursors = copy(pinned = x)

    /** Handles a click at [x]: pins A there; a click on A, at most [reach] beside it, removes both cursors. */
    public fun clicked(x: Double, reach: Double): Cursors = if (isNear(pinned, x, reach)) Cursors(hover = x) else pinnedAt(x)

    /** Handles a Shift-click at [x]: puts B there, or A if there is none; a click on B, at most [reach] beside it, removes B. */
    public fun shiftClicked(x: Double, reach: Double): Cursors = when {
        !isPinned -> pinnedAt(x)
        isNear(second, x, reach) -> copy(second = null)
        else -> copy(second = x)
    }

    /** Pins A where values are read, and puts B there as well, to be [moved]; removes an existing B. */
    public fun withSecond(): Cursors = if (second == null) copy(pinned = x, second = x) else copy(second = null)

    /** Moves A, or B if there is one, by [step], and pins it. If A has no place, it starts at [start]. */
    public fun moved(start: Double, step: (Double) -> Double): Cursors = when {
        second != null -> copy(second = step(second))
        else -> pinnedAt(x?.let(step) ?: start)
    }

    /** The place of the cursor that [moved] moves; null for none. */
    public val moving: Double? get() = second ?: x

    /** Removes what came last: B, or else the pin of A, or else the cursor. */
    public fun cancelled(): Cursors = when {
        second != null -> copy(second = null)
        isPinned -> copy(pinned = null)
        else -> copy(hover = null)
    }

    private fun isNear(cursor: Double?, x: Double, reach: Double) = cursor != null && abs(cursor - x) <= reach

    public companion object {
        /** The label of [between] in front ends. */
        public const val BETWEEN: String = "Between A and B"

        /** The maximum distance, in CSS pixels or dp, at which a click is still on a cursor. */
        public const val REACH: Double = 5.0

        /** The same for a finger, in CSS pixels. */
        public const val FINGER_REACH: Double = 24.0
    }
}
