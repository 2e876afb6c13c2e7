package badlog.core.number

/**
 * The five significant digits of `String.format("%.5g")` on Java 17 for any finite double above zero, by integer
 * arithmetic alone.
 *
 * Java first generates decimal digits until the remainder is within a margin around the value, then rounds those
 * digits half up to five. The margin is half the distance to the next double away from zero; for a power of two it is
 * half of that again.
 *
 * The generated digits can stop at a tie between two five-digit numbers if the tie is within the margin, and never
 * pass one that is not. So as long as the margin is small compared with the sixth digit, the value rounds up if and
 * only if value plus margin is above the tie. That turns the digit generation into one multiplication and one
 * comparison. Subnormal values with fewer than 21 significant bits have a wider margin; their digits are generated
 * one by one.
 *
 * Immutable, and so thread-safe.
 */
internal class ExactDigits {
    private val powers = PowersOfTen96(MIN_POWER, MAX_POWER)

    /**
     * Rounds [magnitude], which is finite and above zero.
     *
     * @return digits and exponent in one number, see [digitsOf] and [exponentOf]
     */
    fun round(magnitude: Double): Int {
        val bits = magnitude.toRawBits()
        val biased = (bits ushr FRACTION_BITS).toInt()
        val fraction = bits and FRACTION_MASK
        if (biased == 0 && fraction < FEW_BITS_LIMIT) return roundFewBits(fraction)
        val significand = if (biased == 0) fraction else fraction or (FRACTION_MASK + 1)
        val unitExponent = if (biased == 0) MIN_UNIT_EXPONENT else biased - 1 + MIN_UNIT_EXPONENT
        return if (significand and (significand - 1) == 0L) {
            roundReach(4 * significand + 1, unitExponent - 2)
        } else {
            roundReach(2 * significand + 1, unitExponent - 1)
        }
    }

    /**
     * Rounds [reach] times two to the [exponent], value plus margin, to the nearest, a tie down.
     *
     * The scaled number is `reach * 2^exponent * 10^power` with the power chosen to give it five or six digits before
     * the point. The table holds 96 bits of the power of ten, cut off. So the product is never too large, and too
     * small by less than 2^-77: a factor of 1 - 2^-95 on a number below 2^18. A search by continued fractions over all
     * exponents found that no number above a tie is closer to it than 2^-65 (3.77845e-250 comes closest), so the
     * deficit never pulls one down to its tie.
     *
     * Value plus margin can be exactly a tie from 2.95e20 to 1.19e21 only. A tie there has 15 or 16 zeros at its end,
     * and Java does not count the end of the margin as within it. The power is negative and cut off, so the product
     * comes out below the tie, as it should.
     */
    private fun roundReach(reach: Long, exponent: Int): Int {
        val shift = reach.countLeadingZeroBits()
        val factor = reach shl shift
        val top = exponent + 63 - shift
        // Multiplying by log10(2) and rounding down is right for all exponents of doubles. 10^(decimal + 1) may still be within the binade.
        var decimal = (top * LOG10_OF_2) shr LOG10_OF_2_SHIFT
        var digits = scale(factor, top, 4 - decimal)
        if (digits >= 100_000) {
            decimal++
            digits = scale(factor, top, 4 - decimal)
        }
        return pack(digits, decimal)
    }

    /** Returns `factor * 2^(top - 63) * 10^power` rounded, with [factor] unsigned and its top bit set. */
    private fun scale(factor: Long, top: Int, power: Int): Int {
        val high = factor ushr 32
        val low = factor and LOW_HALF
        val power0 = powers.low(power)
        val power1 = powers.middle(power)
        val power2 = powers.high(power)
        // Schoolbook multiplication of two by three 32-bit words keeping only the top 64 bits. No sum exceeds 64
        // bits, and all of them are unsigned.
        val a = high * power0 + ((low * power0) ushr 32)
        val b = low * power1 + (a and LOW_HALF)
        val c = high * power1 + (a ushr 32) + (b ushr 32)
        val d = low * power2 + (c and LOW_HALF)
        val product = high * power2 + (c ushr 32) + (d ushr 32)
        val integerBits = top + PowersOfTen96.log2Floor(power) + 2
        return (((product ushr (63 - integerBits)) + 1) ushr 1).toInt()
    }

    /**
     * Rounds [units] times 2^-1074, less than 2^20 units.
     *
     * Numbers are scaled by 10^336 and cut off to integers. They are exact to 1 in 10^12, which does not decide any of
     * the comparisons here: all possible values were tried.
     */
    private fun roundFewBits(units: Long): Int {
        val scaled = units * UNIT + units * UNIT_REST / UNIT_REST_SCALE
        val margin = if (units and (units - 1) == 0L) UNIT / 4 else UNIT / 2
        // Java's first digit is zero if the value is below a power of ten within the margin. It generates two digits
        // before it looks at the margin.
        var place = 1_000_000_000_000_000_000L
        while (place > scaled + margin) place /= 10
        var rest: Long
        do {
            place /= 10
            rest = scaled % place
        } while (rest > margin && place - rest > margin)
        val up = place - rest <= margin && (rest > margin || rest > place - rest)
        return roundGenerated(if (up) scaled - rest + place else scaled - rest)
    }

    private fun roundGenerated(generated: Long): Int {
        var unit = 100_000_000_000_000L
        var decimal = 18 - FEW_BITS_SCALE
        while (unit * 10_000 > generated) {
            unit /= 10
            decimal--
        }
        val digits = ((generated + unit / 2) / unit).toInt()
        return if (digits == 100_000) pack(10_000, decimal + 1) else pack(digits, decimal)
    }

    companion object {
        /** Returns the five digits, from 10000 to 99999. */
        fun digitsOf(rounded: Int): Int = rounded and DIGITS_MASK

        /** Returns the decimal exponent of the first of the five digits. */
        fun exponentOf(rounded: Int): Int = rounded shr DIGITS_BITS

        private fun pack(digits: Int, exponent: Int): Int = (exponent shl DIGITS_BITS) or digits

        private const val DIGITS_BITS = 17
        private const val DIGITS_MASK = (1 shl DIGITS_BITS) - 1

        /** The largest double has a decimal exponent of 308. */
        private const val MIN_POWER = 4 - 308

        /** 2^20 units of 2^-1074 have a decimal exponent of -318. */
        private const val MAX_POWER = 4 + 318

        private const val FRACTION_BITS = 52
        private const val FRACTION_MASK = (1L shl FRACTION_BITS) - 1
        private const val MIN_UNIT_EXPONENT = -1074
        private const val LOW_HALF = 0xFFFF_FFFFL

        private const val LOG10_OF_2 = 315_653
        private const val LOG10_OF_2_SHIFT = 20

        private const val FEW_BITS_LIMIT = 1L shl 20
        private const val FEW_BITS_SCALE = 336

        /** 2^-1074 is 4940656458412.4654417657 times 10^-336. */
        private const val UNIT = 4_940_656_458_412L
        private const val UNIT_REST = 4_654_417_657L
        private const val UNIT_REST_SCALE = 10_000_000_000L
    }
}
