package badlog.samples.robot

// StrictMath, because Math may differ in the last digit from one processor to the next, and so would the bags.

fun sine(angle: Double): Double = StrictMath.sin(angle)

fun cosine(angle: Double): Double = StrictMath.cos(angle)

fun direction(dx: Double, dy: Double): Double = StrictMath.atan2(dy, dx)

fun degrees(radians: Double): Double = radians * 180 / StrictMath.PI

/** Returns [angle], wrapped to the range from -π to π. */
fun wrapped(angle: Double): Double = StrictMath.IEEEremainder(angle, 2 * StrictMath.PI)
