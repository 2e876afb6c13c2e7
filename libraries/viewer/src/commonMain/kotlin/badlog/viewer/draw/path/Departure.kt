package badlog.viewer.draw.path

import badlog.core.analysis.Series
import badlog.signals.pose.PLAN_LIMIT
import badlog.signals.pose.PLAN_PATIENCE
import badlog.viewer.text.fixedText

/**
 * The moment at which a robot left its planned path.
 *
 * @property time the time.
 * @property index the index of the driven path's sample at that time.
 * @property farthest the largest distance from the plan before the robot came back or the plan ended, in meters.
 */
internal class Departure(val time: Double, val index: Int, val farthest: Double) {
    /** Returns a sentence about the departure; [moment] is the text of its time. */
    fun text(moment: String): String = "Left the plan at $moment, by up to ${fixedText(farthest, 2)} m"

    companion object {
        /**
         * Returns the first moment in [distances] from which the robot was more than [PLAN_LIMIT] away for [PLAN_PATIENCE]. Null if there
         * is none.
         *
         * @param second one second in the unit of the x axis.
         */
        fun of(distances: Series, second: Double): Departure? {
            var since = -1
            var farthest = 0.0
            for (i in 0..distances.size) {
                val distance = if (i < distances.size) distances.y[i] else Double.NaN
                if (distance > PLAN_LIMIT) {
                    if (since < 0) since = i
                    farthest = maxOf(farthest, distance)
                } else if (since >= 0) {
                    val end = distances.x[minOf(i, distances.size - 1)]
                    if (end - distances.x[since] >= PLAN_PATIENCE * second) return Departure(distances.x[since], since, farthest)
                    since = -1
                    farthest = 0.0
                }
            }
            return null
        }
    }
}
