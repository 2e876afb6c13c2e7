package badlog.signals.derived

/**
 * Returns how far each module of a drive lags behind its target angle, relative to the worst other one. It is 1.0 in a healthy drive, since
 * all are steered alike. It counts all the time in which the module turns while it drives. The lag is divided by the movement of its
 * target, so that a module that has to turn more does not seem slower. Returns null if a module hardly drove. The result of a module is
 * null if the others are not alike: late measurements are then likelier than two bad modules.
 *
 * @param angles the measured angles at [times], in rad; each module has a list of its own in [targets] and [speeds], too.
 */
fun moduleAngleLags(
    times: DoubleArray,
    angles: List<DoubleArray>,
    targets: List<DoubleArray>,
    speeds: List<DoubleArray>,
    isEnabled: BooleanArray,
): List<Double?>? {
    val behind = angles.indices.map { at ->
        var error = 0.0
        var turned = 0.0
        var count = 0
        for (i in 1 until times.size) {
            val isDriven = isEnabled[i] && isEnabled[i - 1] && isDriving(speeds[at][i]) && isDriving(speeds[at][i - 1])
            val off = halfTurnError(targets[at][i] - angles[at][i])
            val step = halfTurnError(targets[at][i] - targets[at][i - 1])
            if (!isDriven || off.isNaN() || step.isNaN()) continue
            error += minOf(off, FARTHEST)
            turned += minOf(step, FARTHEST)
            count++
        }
        if (count < MIN_SAMPLES || turned < MIN_TURNED) return null
        // An error below a sensor's resolution is not a lag.
        (error + RESOLUTION * count) / turned
    }
    return behind.mapIndexed { at, own ->
        val others = behind.filterIndexed { index, _ -> index != at }
        if (others.max() > ALIKE_LAGS * others.min()) null else own / others.max()
    }
}

/** A target that jumps, and an angle that is far away, do not show how fast a module turns. In degrees. */
private const val FARTHEST = 20.0

/** In degrees. */
private const val RESOLUTION = 0.2
private const val MIN_SAMPLES = 500

/** In degrees. */
private const val MIN_TURNED = 360.0
private const val ALIKE_LAGS = 1.12
