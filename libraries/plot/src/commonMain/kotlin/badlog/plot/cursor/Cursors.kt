package badlog.plot.cursor

import badlog.analysis.Span
import kotlin.math.abs

/**
 * The places on x at which a person reads values. Never changes; each transition gives another one.
 *
 * @property pinned the first cursor, A, which stays where it was put; null for none.
 * @property second the second one, B, which A is compared with; null for none, as always without A.
 * @property hover where the pointer is, or was last; null for nowhere.
 */
public data class Cursors(public val pinned: Double? = null, public val second: Double? = null, public val hover: Double? = null) {
    /** Where values are read: at A, or without it below the pointer; null for nowhere. */
    public val x: Double? get() = pinned ?: hover

    /** Where a person looks for marks: below the pointer, or without one at A; null for nowhere. */
    public val pointed: Double? get() = hover ?: pinned

    /** Whether A stays where it is, however the pointer moves. */
    public val isPinned: Boolean get() = pinned != null

    /** From A to B, or from B to A where that comes first; null unless both are there, apart from each other. */
    public val between: Span?
        get() = if (pinned == null || second == null || pinned == second) null else Span(minOf(pinned, second), maxOf(pinned, second))

    /** The pointer passes over [x]; neither A nor B moves. */
    public fun hovering(x: Double): Cursors = copy(hover = x)

    /** The pointer leaves the graphs. Where nothing is pinned, the last place can still be read. */
    public fun left(): Cursors = if (isPinned) copy(hover = null) else this

    /** A is pinned at [x]. */
    public fun pinnedAt(x: Double): Cursors = copy(pinned = x)

    /** A click at [x] pins A there; one on A, at most [reach] beside it, lets both cursors go. */
    public fun clicked(x: Double, reach: Double): Cursors = if (isNear(pinned, x, reach)) Cursors(hover = x) else pinnedAt(x)

    /** A click with Shift at [x] puts B there, or A where there is none; one on B, at most [reach] beside it, takes B away. */
    public fun shiftClicked(x: Double, reach: Double): Cursors = when {
        !isPinned -> pinnedAt(x)
        isNear(second, x, reach) -> copy(second = null)
        else -> copy(second = x)
    }

    /** Pins A where values are read and puts B there as well, to be [moved] away; takes B away where it is. */
    public fun withSecond(): Cursors = if (second == null) copy(pinned = x, second = x) else copy(second = null)

    /** A goes to where [step] leads from it, or B where there is one; pinned from now on. [start] is where A begins that was nowhere. */
    public fun moved(start: Double, step: (Double) -> Double): Cursors = when {
        second != null -> copy(second = step(second))
        else -> pinnedAt(x?.let(step) ?: start)
    }

    /** The cursor that [moved] moves; null for nowhere. */
    public val moving: Double? get() = second ?: x

    /** Takes away what came last: B, else the pin of A, else the cursor. */
    public fun cancelled(): Cursors = when {
        second != null -> copy(second = null)
        isPinned -> copy(pinned = null)
        else -> copy(hover = null)
    }

    private fun isNear(cursor: Double?, x: Double, reach: Double) = cursor != null && abs(cursor - x) <= reach

    public companion object {
        /** What front ends call [between]. */
        public const val BETWEEN: String = "Between A and B"

        /** So many CSS pixels or dp beside a cursor a click is still on it. */
        public const val REACH: Double = 5.0

        /** So many CSS pixels beside a cursor a finger is still on it. */
        public const val FINGER_REACH: Double = 24.0
    }
}
