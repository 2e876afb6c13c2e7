package badlog.viewer.session.video

import badlog.core.analysis.Span
import kotlin.math.abs
import kotlin.math.round

/**
 * The alignment of a video with a log: the x that each of its seconds shows. Immutable.
 *
 * @property startSeconds the start of the video on the log's time axis, in seconds, to a tenth of a millisecond; negative if the video
 *   began before x was 0.
 */
class VideoAlignment(startSeconds: Double) {
    val startSeconds: Double = round(startSeconds * PER_SECOND) / PER_SECOND

    /** Returns the x that the video shows at [seconds] from its start; one unit of x is [secondsOfX] seconds. */
    fun xAt(seconds: Double, secondsOfX: Double): Double = (startSeconds + seconds) / secondsOfX

    /**
     * Returns the second of the video that shows [x]; one unit of x is [secondsOfX] seconds. It is negative or beyond the end if the
     * video does not show x.
     */
    fun secondsAt(x: Double, secondsOfX: Double): Double = x * secondsOfX - startSeconds

    companion object {
        /** Returns the alignment of a video that shows [x] at [seconds] from its start. One unit of x is [secondsOfX] seconds. */
        fun of(seconds: Double, x: Double, secondsOfX: Double): VideoAlignment = VideoAlignment(x * secondsOfX - seconds)

        /** The reason why a frame cannot be aligned with the cursor. */
        const val NO_CURSOR: String = "Click a graph first."

        /** The reason why a frame cannot be aligned with the enabling of the robot. */
        const val NEVER_ENABLED: String = "This log does not say when the robot was enabled."

        /** The reason why no video can be aligned with a log. */
        const val NO_TIME: String = "The x axis of this log is not a time, so no video can be shown beside it."

        private const val PER_SECOND = 10_000.0
    }
}

/** Returns the instruction for aligning a video with a log. [hasEnabled] says whether the log shows when the robot was enabled. */
fun alignmentHint(hasEnabled: Boolean): String = if (hasEnabled) {
    "Find the first frame in which the robot is enabled, and click “Enabled here”."
} else {
    "Move the cursor to the time of this frame, and click the link button."
}

/**
 * Returns the x at which the robot becomes enabled, to align a video. It is the start of the first span of [enabled] that begins in
 * [visible], otherwise of the very first. [enabled] is in the order of x. Null if the log does not show when the robot was enabled.
 */
fun enabledStart(enabled: List<Span>, visible: Span): Double? = (enabled.firstOrNull { it.from in visible } ?: enabled.firstOrNull())?.from

/**
 * The stored facts about a video of a log.
 *
 * @property name the name of the video's file.
 * @property alignment the alignment with the log; null before the video is aligned.
 */
class VideoNote(val name: String, val alignment: VideoAlignment?) {
    /** Returns the note as one line, which [videoNoteOf] reads: `12.5 match.mp4`, and `- match.mp4` without an alignment. */
    fun toText(): String = "${alignment?.startSeconds ?: NONE} $name"
}

/** Returns the note that [VideoNote.toText] wrote as [text]; null for any other text. */
fun videoNoteOf(text: String): VideoNote? {
    val (start, name) = text.split(' ', limit = 2).takeIf { it.size == 2 } ?: return null
    if (start == NONE) return VideoNote(name, null)
    return start.toDoubleOrNull()?.takeIf(Double::isFinite)?.let { VideoNote(name, VideoAlignment(it)) }
}

/**
 * Returns [notes], the stored notes about a log's videos, with this one. It replaces an older note about the same video. Each note is one
 * line.
 */
fun VideoNote.within(notes: String): String =
    (notes.lines().filter { line -> videoNoteOf(line).let { it != null && it.name != name } } + toText()).joinToString("\n")

private const val NONE = "-"

/** The playback speeds of a video and of the cursor; 1 is the recorded speed. */
val VIDEO_SPEEDS: List<Double> = listOf(0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)

/** Returns the speed [steps] higher than [speed], or lower if negative; it stops at either end. */
fun speedAfter(speed: Double, steps: Int): Double {
    val nearest = VIDEO_SPEEDS.indices.minBy { abs(VIDEO_SPEEDS[it] - speed) }
    return VIDEO_SPEEDS[(nearest + steps).coerceIn(VIDEO_SPEEDS.indices)]
}
