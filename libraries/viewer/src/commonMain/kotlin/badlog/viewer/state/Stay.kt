package badlog.viewer.state

import badlog.core.analysis.Span

/**
 * Whether a person stays at the end of a log that grows. They do from when they asked for that until they go elsewhere: hovering over
 * graphs, and zooming and panning with the end in sight, do not. Immutable; each transition returns a new one.
 *
 * @property place where a person who wants to stay at the end was put last; null for one who does not.
 * @property held the visible range that a person wants to keep, though it ends where the log ended; null for none.
 */
data class Stay(val place: Place? = null, val held: Span? = null) {
    /** Returns whether a person who is at [now] is at the end, and has not gone elsewhere. */
    fun isAt(now: Place): Boolean {
        if (place == null || !now.range.isAtEnd || now.range.full != place.range.full) return false
        return now.cursors.pinned == place.cursors.pinned && now.cursors.second == place.cursors.second
    }

    /** Returns whether such a person has also looked at nothing since: at no part of it, and at no selected range. */
    fun isUntouched(now: Place): Boolean = isAt(now) && place?.range?.visible == now.range.visible && now.selection == null

    /** The person is at [end], the end of the log, and wants to stay at its end. */
    fun begun(end: Place): Stay = Stay(place = end)

    /** The person wants to stay at [now], though the log grows. */
    internal fun paused(now: Place): Stay = Stay(held = now.range.visible.takeIf { now.range.isZoomed })

    /** Handles that the log has grown, and is shown at [shown] to a person who was at [before]. */
    internal fun grown(before: Place, shown: Place): Stayed {
        if (isAt(before)) return shown.movedToEnd().let { Stayed(begun(it), it) }
        val kept = held?.takeIf { it == before.range.visible && before.range.full.from == shown.range.full.from }
        val there = if (kept == null) shown else shown.copy(range = shown.range.moved(kept.from, kept.to))
        return Stayed(Stay(held = if (kept == null) null else there.range.visible), there)
    }
}

/**
 * What follows for a person from the growth of a log.
 *
 * @property place where they are in it now.
 */
internal class Stayed(val stay: Stay, val place: Place)
