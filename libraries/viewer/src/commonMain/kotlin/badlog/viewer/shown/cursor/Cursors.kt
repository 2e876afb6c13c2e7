package badlog.viewer.shown.cursor

import badlog.core.analysis.Span
import kotlin.math.abs

/**
 * The places on x at which a person reads values. Immutable; each transition returns a new one.
 *
 * @property pinned the first cursor, A, which stays where it was put; null for none.
 * @property second the second one, B, with which A is compared; null for none, and whenever there is no A.
 * @property hover the pointer's current or last place; null for nowhere.
 */
data class Cursors(val pinned: Double? = null, val second: Double? = null, val hover: Double? = null) {
    /** Where values are read: at A, or otherwise under the pointer; null for nowhere. */
    val x: Double? get() = pinned ?: hover

    /** The cursors without the pointer, as a figure shows them. */
    val withoutPointer: Cursors get() = copy(hover = null)

    /** Where a person looks for marks: under the pointer, or otherwise at A; null for nowhere. */
    val pointed: Double? get() = hover ?: pinned

    /** Whether A stays where it is when the pointer moves. */
    val isPinned: Boolean get() = pinned != null

    /** From A to B, or from B to A if B comes first; null unless both exist at different places. */
    val between: Span?
        get() = if (pinned == null || second == null || pinned == second) null else Span(minOf(pinned, second), maxOf(pinned, second))

    /** Moves the pointer to [x]; neither A nor B moves. */
    internal fun hovering(x: Double): Cursors = copy(hover = x)

    /** Removes the pointer, which left the graphs. If nothing is pinned, values are still read at its last place. */
    internal fun left(): Cursors = if (isPinned) copy(hover = null) else this

    internal fun pinnedAt(x: Double): Cursors = copy(pinned = x)

    /** Handles a click at [x]: pins A there; a click on A, at most [reach] beside it, removes both cursors. */
    internal fun clicked(x: Double, reach: Double): Cursors = if (isNear(pinned, x, reach)) Cursors(hover = x) else pinnedAt(x)

    /** Handles a Shift-click at [x]: puts B there, or A if there is none; a click on B, at most [reach] beside it, removes B. */
    internal fun shiftClicked(x: Double, reach: Double): Cursors = when {
        !isPinned -> pinnedAt(x)
        isNear(second, x, reach) -> copy(second = null)
        else -> copy(second = x)
    }

    /** Pins A where values are read, and puts B there as well, to be [moved]; removes an existing B. */
    internal fun withSecond(): Cursors = if (second == null) copy(pinned = x, second = x) else copy(second = null)

    /** Moves A, or B if there is one, by [step], and pins it. If A has no place, it starts at [start]. */
    internal fun moved(start: Double, step: (Double) -> Double): Cursors = when {
        second != null -> copy(second = step(second))
        else -> pinnedAt(x?.let(step) ?: start)
    }

    /** The place of the cursor that [moved] moves; null for none. */
    val moving: Double? get() = second ?: x

    /** Removes what came last: B, or else the pin of A, or else the cursor. */
    internal fun cancelled(): Cursors = when {
        second != null -> copy(second = null)
        isPinned -> copy(pinned = null)
        else -> copy(hover = null)
    }

    private fun isNear(cursor: Double?, x: Double, reach: Double) = cursor != null && abs(cursor - x) <= reach

    companion object {
        /** The label of [between] in front ends. */
        const val BETWEEN: String = "Between A and B"

        /** The maximum distance, in CSS pixels or dp, at which a click is still on a cursor. */
        const val REACH: Double = 5.0

        /** The same for a finger, in CSS pixels. */
        const val FINGER_REACH: Double = 24.0
    }
}
