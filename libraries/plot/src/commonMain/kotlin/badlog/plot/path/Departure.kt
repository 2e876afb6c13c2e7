package badlog.plot.path

import badlog.analysis.Span
import badlog.plot.text.fixedText
import kotlin.math.sqrt

/**
 * Where a robot left its plan.
 *
 * @property time when.
 * @property index the sample of the driven path.
 * @property farthest how far away it went before it came back, or the plan ended; in meters.
 */
public class Departure internal constructor(public val time: Double, public val index: Int, public val farthest: Double) {
    /** It as a sentence, where [moment] is its time as a text. */
    public fun text(moment: String): String = "Left the plan at $moment, by up to ${fixedText(farthest, 2)} m"

    public companion object {
        /** Who is nearer than this to where the plan has it is on it, in meters. */
        public const val LIMIT: Double = 0.5

        /**
         * The first moment of [spans] from which [driven] was more than [LIMIT] away from [planned] for [seconds]; null for none. What is
         * planned counts for as long as it goes on changing: afterwards nobody follows it.
         *
         * @param seconds in the unit of the x axis.
         */
        public fun of(driven: Trail, planned: Trail, spans: List<Span>, seconds: Double): Departure? {
            for (span in spans) find(driven, planned, span, seconds)?.let { return it }
            return null
        }

        private fun find(driven: Trail, planned: Trail, span: Span, seconds: Double): Departure? {
            val end = minOf(span.to, lastMove(planned, span))
            var since = -1
            var farthest = 0.0
            for (i in driven.startOf(span) until driven.endOf(Span(span.from, maxOf(span.from, end)))) {
                val at = planned.indexAt(driven.times[i])
                if (at < 0 || !planned.isPlace(at) || !driven.isPlace(i)) continue
                val right = driven.x[i] - planned.x[at]
                val up = driven.y[i] - planned.y[at]
                val distance = sqrt(right * right + up * up)
                if (distance > LIMIT) {
                    if (since < 0) since = i
                    farthest = maxOf(farthest, distance)
                } else {
                    if (since >= 0 && driven.times[i] - driven.times[since] >= seconds) break
                    since = -1
                    farthest = 0.0
                }
            }
            if (since < 0 || end - driven.times[since] < seconds) return null
            return Departure(driven.times[since], since, farthest)
        }

        private fun lastMove(planned: Trail, span: Span): Double {
            var at = planned.endOf(span) - 1
            val first = planned.startOf(span)
            while (at > first && planned.x[at] == planned.x[at - 1] && planned.y[at] == planned.y[at - 1]) at--
            return if (at < first) span.from else planned.times[at]
        }
    }
}
