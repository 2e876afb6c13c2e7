package badlog.samples.robot

/**
 * Seeded random numbers by SplitMix64. The generators of the standard libraries may change with a release, and the
 * checked-in bags would change with them.
 */
class Noise(seed: Long) {
    private var state = seed

    /** Returns a number evenly distributed over [0, 1). */
    fun unit(): Double {
        state += -0x61c8864680b583ebL
        var bits = state
        bits = (bits xor (bits ushr 30)) * -0x40a7b892e31b1a47L
        bits = (bits xor (bits ushr 27)) * -0x6b2fb644ecceee15L
        return ((bits xor (bits ushr 31)) ushr 11) * UNIT
    }

    /** Returns a nearly normally distributed number around 0 with the standard deviation [deviation]. */
    fun around(deviation: Double): Double = (unit() + unit() + unit() + unit() - 2) * ROOT_OF_3 * deviation
}

private const val UNIT = 1.0 / (1L shl 53)

// The sum of four evenly distributed numbers has a variance of 4/12.
private const val ROOT_OF_3 = 1.7320508075688772
