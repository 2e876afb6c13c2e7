package badlog.expression.samples

import badlog.core.analysis.Span
import kotlin.math.sqrt

/** The regression of [y] on [x] while both are known, weighted by time; moments have equal weights. */
internal class Regression(y: Value, x: Value, range: Span?) {
    private var weight = 0.0
    private var centerX = 0.0
    private var centerY = 0.0
    private var squaresX = 0.0
    private var squaresY = 0.0
    private var products = 0.0

    init {
        val joined = Joined(listOf(y, x), Double.NaN, isEither = false)
        val (ofY, ofX) = joined.operands
        val times = joined.x!!
        val clock = Column(times, times, null, joined.isMomentary, joined.stretches)
        val end = clock.end(range)
        for (i in times.indices) {
            if (ofX[i].isFinite() && ofY[i].isFinite()) add(ofX[i], ofY[i], if (joined.isMomentary) 1.0 else clock.width(i, end))
        }
    }

    private fun add(x: Double, y: Double, share: Double) {
        if (share <= 0) return
        weight += share
        val fromX = x - centerX
        val fromY = y - centerY
        centerX += fromX * (share / weight)
        centerY += fromY * (share / weight)
        squaresX += share * fromX * (x - centerX)
        squaresY += share * fromY * (y - centerY)
        products += share * fromX * (y - centerY)
    }

    /** The increase of y per unit of x, by least squares. Unknown if x never changes. */
    val slope: Scalar get() = Scalar(if (squaresX > 0) products / squaresX else Double.NaN)

    /** Pearson's correlation, from -1 to 1. Unknown if one of them never changes. */
    val correlation: Scalar
        get() = Scalar(if (squaresX > 0 && squaresY > 0) (products / sqrt(squaresX) / sqrt(squaresY)).coerceIn(-1.0, 1.0) else Double.NaN)
}
