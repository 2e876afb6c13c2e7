package badlog.viewer.shown.cursor

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
import kotlin.math.abs

/**
 * The places on x at which a person reads values. Immutable; each transition returns a new one.
 *
 * @property pinned the first cursor, A, which stays where it was put; null if there is none.
 * @property second the second cursor, B, for a comparison with A; null if there is none, and whenever there is no A.
 * @property hover the current or last place of the pointer; null if there is none.
 */
data class Cursors(val pinned: Double? = null, val second: Double? = null, val hover: Double? = null) {
    /** The place where values are read: A, or otherwise the pointer; null if there is neither. */
    val x: Double? get() = pinned ?: hover

    /** The cursors without the pointer, as a figure shows them. */
    val withoutPointer: Cursors get() = copy(hover = null)

    /** The place where a person looks for marks: the pointer, or otherwise A; null if there is neither. */
    val pointed: Double? get() = hover ?: pinned

    /** Whether A stays in place when the pointer moves. */
    val isPinned: Boolean get() = pinned != null

    /** The range between A and B, whichever is first; null unless both exist at different places. */
    val between: Span?
        get() = if (pinned == null || second == null || pinned == second) null else Span(minOf(pinned, second), maxOf(pinned, second))

    /** Moves the pointer to [x]; neither A nor B moves. */
    internal fun hovering(x: Double): Cursors = copy(hover = x)

    /** Removes the pointer, which left the graphs. Without a pinned cursor, values are still read at its last place. */
    internal fun left(): Cursors = if (isPinned) copy(hover = null) else this

    internal fun pinnedAt(x: Double): Cursors = copy(pinned = x)

    /** Handles a click at [x], which pins A there. A click on A, at most [reach] beside it, removes both cursors. */
    internal fun clicked(x: Double, reach: Double): Cursors = if (isNear(pinned, x, reach)) Cursors(hover = x) else pinnedAt(x)

    /** Handles a Shift-click at [x], which puts B there, or A if there is none. A click on B, at most [reach] beside it, removes B. */
    internal fun shiftClicked(x: Double, reach: Double): Cursors = when {
        !isPinned -> pinnedAt(x)
        isNear(second, x, reach) -> copy(second = null)
        else -> copy(second = x)
    }

    /** Pins A where values are read, and puts B at the same place, for [moved] to move it; if B exists, removes it instead. */
    internal fun withSecond(): Cursors = if (second == null) copy(pinned = x, second = x) else copy(second = null)

    /** Moves B by [step] if there is one; otherwise moves and pins A. Without a place, A starts at [start]. */
    internal fun moved(start: Double, step: (Double) -> Double): Cursors = when {
        second != null -> copy(second = step(second))
        else -> pinnedAt(x?.let(step) ?: start)
    }

    /** The place of the cursor that [moved] moves; null if there is none. */
    val moving: Double? get() = second ?: x

    /** Removes the latest of them: B, otherwise the pin of A, otherwise the cursor. */
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

        /** The maximum distance for a finger, in CSS pixels or dp. */
        const val FINGER_REACH: Double = 24.0
    }
}

/**
 * Returns the values of this line at cursors at [a] and [b]. The difference and the slope follow: `A 12.1 · B 9.3 · Δ -2.8 · -1.4 V/s`.
 * States and gaps have no difference and slope.
 *
 * @param xUnit the unit of x.
 * @param sampleText formats a sample.
 */
fun GraphSeries.comparisonText(a: Double, b: Double, xUnit: String, sampleText: (Double) -> String = ::numberText): String {
    val one = indexAt(a)
    val other = indexAt(b)
    val texts = "A ${textOf(one, sampleText)} · B ${textOf(other, sampleText)}"
    if (states != null || one < 0 || other < 0) return texts
    val change = data.y[other] - data.y[one]
    if (change.isNaN()) return texts
    val slope = change / (dotAt(b) - dotAt(a))
    val text = "$texts · Δ ${numberText(change)}"
    return if (slope.isFinite()) "$text · ${withUnit(numberText(slope), Units.ofDerivative(unit, xUnit))}" else text
}
