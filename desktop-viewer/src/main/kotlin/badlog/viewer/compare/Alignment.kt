package badlog.viewer.compare

import badlog.viewer.recording.OpenRecording

/**
 * Which moment of each recording stands at the same x.
 *
 * @property title what the window calls it.
 * @property hint what it does, in a sentence.
 */
internal enum class Alignment(val title: String, val hint: String) {
    /** The first x. */
    START("Start", "Every recording begins where the open one begins."),

    /** The first moment at which the robot was enabled; the first x where nothing tells. */
    ENABLED("Enabled", "The robot is first enabled at the same place in all; a recording that does not tell begins with the open one."),

    /** The x that was logged. */
    AS_LOGGED("As logged", "Every recording stands at the x it was logged with."),

    /** What a person has moved it to. */
    BY_HAND("By hand", "Every recording stands where you move it."),
}

/** The x in [recording] that this alignment puts at one place with that of the others. */
internal fun Alignment.momentIn(recording: OpenRecording): Double = when (this) {
    Alignment.START -> recording.firstX
    Alignment.ENABLED -> recording.enabled.firstOrNull()?.span?.from ?: recording.firstX
    Alignment.AS_LOGGED, Alignment.BY_HAND -> 0.0
}
