package badlog.viewer.session.video

/** The playback speeds of a video; 1 is the recorded speed. */
val VIDEO_SPEEDS: List<Double> = listOf(0.25, 0.5, 1.0, 2.0, 4.0)

/** Returns the next faster of [VIDEO_SPEEDS] after [speed], or the next slower if [steps] is negative. */
fun videoSpeed(speed: Double, steps: Int): Double {
    val now = VIDEO_SPEEDS.indexOfFirst { it >= speed }.let { if (it < 0) VIDEO_SPEEDS.lastIndex else it }
    return VIDEO_SPEEDS[(now + steps).coerceIn(VIDEO_SPEEDS.indices)]
}
