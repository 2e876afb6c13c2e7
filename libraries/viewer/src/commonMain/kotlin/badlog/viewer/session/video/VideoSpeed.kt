package badlog.viewer.session.video

import kotlin.math.abs

/** The playback speeds of a video and of the cursor; 1 is the recorded speed. */
val VIDEO_SPEEDS: List<Double> = listOf(0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)

/** Returns the speed [steps] higher than [speed], or lower if negative; it stops at either end. */
fun speedAfter(speed: Double, steps: Int): Double {
    val nearest = VIDEO_SPEEDS.indices.minBy { abs(VIDEO_SPEEDS[it] - speed) }
    return VIDEO_SPEEDS[(nearest + steps).coerceIn(VIDEO_SPEEDS.indices)]
}
