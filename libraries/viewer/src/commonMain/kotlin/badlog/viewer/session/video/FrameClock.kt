package badlog.viewer.session.video

import kotlin.math.abs
import kotlin.math.roundToInt

/** The duration of a video's frames, learned from the times of displayed frames, because players do not report it. */
class FrameClock {
    private var shown = Double.NaN
    private var guess = FIRST_GUESS
    private var shortest = Double.POSITIVE_INFINITY
    private var seconds = 0.0
    private var frames = 0

    /** The duration of a frame in seconds; a guess until two consecutive frames were displayed. */
    val frameSeconds: Double get() = if (frames == 0) guess else seconds / frames

    /**
     * Records the display of the frame that begins [time] seconds from the video's start.
     *
     * @param isNext whether the video played or stepped there from the previous frame, rather than jumped.
     */
    fun show(time: Double, isNext: Boolean) {
        val passed = abs(time - shown)
        shown = time
        if (!isNext || !(passed in MIN_FRAME..MAX_FRAME)) return
        // A clearly shorter duration shows that frames were skipped before.
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

    /** Records a step that did not leave its frame, which therefore lasts longer than assumed. */
    fun lengthen() {
        guess = minOf(frameSeconds * 2, MAX_FRAME)
        shortest = Double.POSITIVE_INFINITY
        frames = 0
    }

    /**
     * Returns the position to seek for the frame [count] after the one that begins at [time], or before it if negative. Both times are in
     * seconds from the video's start. It is the middle of that frame, because players round, and never before the start.
     */
    fun step(time: Double, count: Int): Double = maxOf(0.0, time + (count + MIDDLE) * frameSeconds)
}

/**
 * The first guess, in seconds. At 60 frames per second, the first step is right; with fewer, it ends too early, and [lengthen] is
 * called.
 */
private const val FIRST_GUESS = 1.0 / 60
private const val MIN_FRAME = 0.002
private const val MAX_FRAME = 0.25
private const val MIDDLE = 0.5

/** The smallest ratio to the shortest duration that rounding explains. */
private const val SAME = 0.75

/** The maximum number of frames for which the rounding error of the shortest duration stays below a frame. */
private const val MAX_COUNT = 8
