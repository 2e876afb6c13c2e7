package badlog.viewer.state

import badlog.core.analysis.Span

/**
 * A person's wish to stay at the end of a growing log. It lasts until the person goes elsewhere; hovering over graphs, and zooming and
 * panning with the end in sight, do not end it. Immutable; each transition returns a new one.
 *
 * @property place the last place at the end that this state moved the person to; null for a person who does not want to stay there.
 * @property held the visible range that a person wants to keep, though it ends where the log ended; null if there is none.
 */
data class EndFollowing(val place: Place? = null, val held: Span? = null) {
    /** Returns whether a person at [now] is at the end, and has not gone elsewhere. */
    fun isAt(now: Place): Boolean {
        if (place == null || !now.range.isAtEnd || now.range.full != place.range.full) return false
        return now.cursors.pinned == place.cursors.pinned && now.cursors.second == place.cursors.second
    }

    /** Returns whether a person at [now] is at the end, and has not zoomed, panned or selected since. */
    fun isUntouched(now: Place): Boolean = isAt(now) && place?.range?.visible == now.range.visible && now.selection == null

    /** Returns the state that keeps a person at the end of the log, which is now [end]. */
    fun begun(end: Place): EndFollowing = EndFollowing(place = end)

    /** Returns the state of a person who wants to stay at [now], though the log grows. */
    internal fun paused(now: Place): EndFollowing = EndFollowing(held = now.range.visible.takeIf { now.range.isZoomed })

    /** Returns the state after the log has grown, and is shown at [shown] to a person who was at [before]. */
    internal fun grown(before: Place, shown: Place): GrownPlace {
        if (isAt(before)) return shown.movedToEnd().let { GrownPlace(begun(it), it) }
        val kept = held?.takeIf { it == before.range.visible && before.range.full.from == shown.range.full.from }
        val there = if (kept == null) shown else shown.copy(range = shown.range.moved(kept.from, kept.to))
        return GrownPlace(EndFollowing(held = if (kept == null) null else there.range.visible), there)
    }
}

/**
 * The effect of the log's growth on a person.
 *
 * @property place the person's place in the log now.
 */
internal class GrownPlace(val following: EndFollowing, val place: Place)
