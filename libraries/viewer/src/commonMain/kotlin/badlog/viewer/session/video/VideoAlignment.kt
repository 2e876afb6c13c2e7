package badlog.viewer.session.video

import badlog.core.analysis.Span
import kotlin.math.round

/**
 * The alignment of a video with a log: which of its seconds shows which x. Immutable.
 *
 * @property startSeconds where on the log's time axis the video begins, in seconds, to a tenth of a millisecond; negative if the video
 *   began before x was 0.
 */
class VideoAlignment(startSeconds: Double) {
    val startSeconds: Double = round(startSeconds * PER_SECOND) / PER_SECOND

    /** Returns the x that the video shows at [seconds] from its start, where [secondsOfX] is the number of seconds in one unit of x. */
    fun xAt(seconds: Double, secondsOfX: Double): Double = (startSeconds + seconds) / secondsOfX

    /** Returns the second of the video that shows [x]; negative or beyond its end if the video does not show it. */
    fun secondsAt(x: Double, secondsOfX: Double): Double = x * secondsOfX - startSeconds

    companion object {
        /** Returns the alignment of a video that shows [x] at [seconds] from its start; one unit of x is [secondsOfX] seconds. */
        fun of(seconds: Double, x: Double, secondsOfX: Double): VideoAlignment = VideoAlignment(x * secondsOfX - seconds)

        /** Why a frame cannot be aligned with the cursor. */
        const val NO_CURSOR: String = "Click a graph first."

        /** Why a frame cannot be aligned with the moment at which the robot was enabled. */
        const val NEVER_ENABLED: String = "This log does not say when the robot was enabled."

        /** Why no video can be aligned with a log. */
        const val NO_TIME: String = "The x axis of this log is not a time, so no video can be shown beside it."

        private const val PER_SECOND = 10_000.0
    }
}

/** Returns how a person aligns a video with a log; [hasEnabled] says whether that shows when the robot was enabled. */
fun alignmentHint(hasEnabled: Boolean): String = if (hasEnabled) {
    "Find the first frame in which the robot is enabled, and click “Enabled here”."
} else {
    "Move the cursor to the time of this frame, and click the link button."
}

/**
 * Returns where a frame belongs in which the robot becomes enabled: the start of the first of [enabled], in the order of x, that begins in
 * [visible]; if none does, that of the very first. Null if the log does not say when the robot was enabled.
 */
fun enabledStart(enabled: List<Span>, visible: Span): Double? = (enabled.firstOrNull { it.from in visible } ?: enabled.firstOrNull())?.from
