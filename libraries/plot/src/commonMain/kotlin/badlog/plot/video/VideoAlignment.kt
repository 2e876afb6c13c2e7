package badlog.plot.video

import badlog.analysis.Span
import kotlin.math.round

/**
 * Where a video lies beside a log: which of its seconds shows which x. Never changes.
 *
 * @property startSeconds where on the log's time axis the video begins, in seconds, to a tenth of a millisecond; negative where the video began
 *   before x was 0.
 */
public class VideoAlignment(startSeconds: Double) {
    public val startSeconds: Double = round(startSeconds * PER_SECOND) / PER_SECOND

    /** The x that the video shows at [seconds] from its start, [secondsOfX] being how many seconds one x is. */
    public fun xAt(seconds: Double, secondsOfX: Double): Double = (startSeconds + seconds) / secondsOfX

    /** The second of the video that shows [x]; negative or beyond its end where it does not show that. */
    public fun secondsAt(x: Double, secondsOfX: Double): Double = x * secondsOfX - startSeconds

    public companion object {
        /** A video that shows [x] at [seconds] from its start, one x being [secondsOfX] seconds. */
        public fun of(seconds: Double, x: Double, secondsOfX: Double): VideoAlignment = VideoAlignment(x * secondsOfX - seconds)

        private const val PER_SECOND = 10_000.0
    }
}

/**
 * Where a frame belongs in which the robot is enabled: where the first of [enabled], in the order of x, begins that does so in [visible]; where
 * none does, the first of all. Null where the log does not say when the robot was enabled.
 */
public fun enabledStart(enabled: List<Span>, visible: Span): Double? =
    (enabled.firstOrNull { it.from in visible } ?: enabled.firstOrNull())?.from
