package badlog.window.video

import badlog.core.analysis.Span
import badlog.viewer.session.video.speedAfter

/**
 * The playback of the cursor.
 *
 * @property isPlaying whether it is running.
 * @property speed the speed relative to the recording; if x is not a time, the whole recording takes a minute at speed 1.
 * @property loops whether it starts over at the end of its range: the selection, or otherwise the visible range.
 */
internal data class Playback(val isPlaying: Boolean = false, val speed: Double = 1.0, val loops: Boolean = false) {
    /**
     * Returns the cursor after advancing by [distance] of x, which is not negative, and the playback from there on. The cursor stays within
     * [range]: at the end, it starts over if the playback loops, otherwise it stops. From outside, it begins at the start of [range].
     */
    fun advanced(cursor: Double?, distance: Double, range: Span): Step {
        val from = cursor?.takeIf { it in range } ?: range.from
        val next = from + distance
        return when {
            next < range.to -> Step(next, this)
            !loops || range.width <= 0 -> Step(range.to, copy(isPlaying = false))
            else -> Step(range.from + (next - range.from).mod(range.width), this)
        }
    }

    /** Returns the playback [steps] faster, see [speedAfter]. */
    fun faster(steps: Int): Playback = copy(speed = speedAfter(speed, steps))

    /**
     * A step of playback.
     *
     * @property cursor the cursor's new place.
     * @property playback the new state of playback.
     */
    data class Step(val cursor: Double, val playback: Playback)
}
