package badlog.viewer.playback

import badlog.analysis.Span

/**
 * How the cursor runs by itself.
 *
 * @property isPlaying whether it runs now.
 * @property speed how many times as fast as it was recorded; an x that is not a time takes a minute at 1.
 * @property loops whether it begins again at the end of what it plays: the selection, or else all that is visible.
 */
internal data class Playback(val isPlaying: Boolean = false, val speed: Double = 1.0, val loops: Boolean = false) {
    /**
     * Returns where the cursor is when [distance] more of x has passed, not negative, and how it goes on from there. It
     * stays within [range]: at the end it begins again when it loops, else it stops. From outside, it begins at the start of
     * [range].
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

    /** Returns the next faster of [SPEEDS], or slower when [steps] is negative. */
    fun faster(steps: Int): Playback {
        val nearest = SPEEDS.indices.minBy { kotlin.math.abs(SPEEDS[it] - speed) }
        return copy(speed = SPEEDS[(nearest + steps).coerceIn(SPEEDS.indices)])
    }

    /**
     * A moment of it.
     *
     * @property cursor where it is.
     * @property playback how it goes on.
     */
    data class Step(val cursor: Double, val playback: Playback)

    companion object {
        /** What a person can choose. */
        val SPEEDS: List<Double> = listOf(0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)
    }
}
