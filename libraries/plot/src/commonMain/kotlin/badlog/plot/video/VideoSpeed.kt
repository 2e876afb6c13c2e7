package badlog.plot.video

/** How many times as fast as it was recorded a video can be played. */
public val VIDEO_SPEEDS: List<Double> = listOf(0.25, 0.5, 1.0, 2.0, 4.0)

/** The next faster of [VIDEO_SPEEDS] after [speed], or the next slower when [steps] is negative. */
public fun videoSpeed(speed: Double, steps: Int): Double {
    val now = VIDEO_SPEEDS.indexOfFirst { it >= speed }.let { if (it < 0) VIDEO_SPEEDS.lastIndex else it }
    return VIDEO_SPEEDS[(now + steps).coerceIn(VIDEO_SPEEDS.indices)]
}
