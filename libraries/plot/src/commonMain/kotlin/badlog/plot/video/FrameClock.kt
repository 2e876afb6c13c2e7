package badlog.plot.video

import kotlin.math.abs
import kotlin.math.roundToInt

/** How long a frame of a video lasts, learned from the times of frames that were shown: players do not tell. */
public class FrameClock {
    private var shown = Double.NaN
    private var guess = FIRST_GUESS
    private var shortest = Double.POSITIVE_INFINITY
    private var seconds = 0.0
    private var frames = 0

    /** How long one lasts, in seconds; a guess until two have been seen one after the other. */
    public val frameSeconds: Double get() = if (frames == 0) guess else seconds / frames

    /**
     * The frame that begins at [time] from the video's start, in seconds, is shown.
     *
     * @param isNext whether the video played or stepped there from the frame shown before, rather than jumped.
     */
    public fun show(time: Double, isNext: Boolean) {
        val passed = abs(time - shown)
        shown = time
        if (!isNext || !(passed in MIN_FRAME..MAX_FRAME)) return
        // Before, frames were left out.
        if (passed < shortest * SAME) {
            shortest = passed
            seconds = 0.0
            frames = 0
        }
        val count = (passed / shortest).roundToInt()
        if (count > MAX_COUNT) return
        seconds += passed
        frames += count
    }

    /** The frame at which a step should have ended is still the one shown: it lasts longer than was thought. */
    public fun lengthen() {
        guess = minOf(frameSeconds * 2, MAX_FRAME)
        shortest = Double.POSITIVE_INFINITY
        frames = 0
    }

    /**
     * Where to go, in seconds from the video's start, to see the frame [count] after the one that begins at [time], or before it when negative:
     * the middle of that frame, since players round; never before the start.
     */
    public fun step(time: Double, count: Int): Double = maxOf(0.0, time + (count + MIDDLE) * frameSeconds)

    private companion object {
        /** Seconds. With 60 frames a second a first step is right; with fewer it ends too early, and [lengthen] is called. */
        const val FIRST_GUESS = 1.0 / 60
        const val MIN_FRAME = 0.002
        const val MAX_FRAME = 0.25
        const val MIDDLE = 0.5

        /** What is shorter than this part of the shortest is no rounding. */
        const val SAME = 0.75

        /** Of so many frames, rounding of the shortest is not yet one more. */
        const val MAX_COUNT = 8
    }
}
