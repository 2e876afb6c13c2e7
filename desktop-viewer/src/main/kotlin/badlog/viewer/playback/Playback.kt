package badlog.viewer.playback

/**
 * How the cursor runs by itself.
 *
 * @property isPlaying whether it runs now.
 * @property speed how many units of x it goes in a second.
 * @property loops whether it begins again at the end of what it plays: the selection, or else all that is visible.
 */
internal data class Playback(val isPlaying: Boolean = false, val speed: Double = 1.0, val loops: Boolean = false)
