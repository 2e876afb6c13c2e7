package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.PI
import kotlin.math.sin

/** The times of [seconds] at 50 samples a second. */
internal fun timesFor(seconds: Int): DoubleArray = DoubleArray(seconds * 50) { it / 50.0 }

internal fun DoubleArray.of(at: (time: Double) -> Double): DoubleArray = DoubleArray(size) { at(this[it]) }

internal fun DoubleArray.series(at: (time: Double) -> Double): Series = Series(this, of(at))

internal fun DoubleArray.always(): BooleanArray = BooleanArray(size) { true }

/** Swings between -1 and 1 in [period] s. */
internal fun swing(time: Double, period: Double = 4.0): Double = sin(2 * PI * time / period)

/** The largest sample of this series in the span of time. */
internal fun Series.most(from: Double = 0.0, to: Double = 1e9): Double = (0 until size).filter { x[it] in from..to && y[it].isFinite() }.maxOfOrNull { y[it] } ?: Double.NaN
