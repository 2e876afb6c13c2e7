package badlog.core.number

/** 10⁰ to 10²²: the powers of ten that a double holds exactly. */
internal val EXACT_POWERS_OF_TEN: DoubleArray = doubleArrayOf(
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
)

/**
 * The top 96 bits of the powers of ten from 10^[min] to 10^[max], truncated, each as three words. `10^power` is their number times
 * `2^(log2Floor(power) - 95)`, or more than that by less than one unit.
 *
 * @param min lowest power, -1000 to 0
 * @param max highest power, 0 to 1000
 */
internal class PowersOfTen96(private val min: Int, max: Int) {
    private val words = IntArray((max - min + 1) * WORDS)

    init {
        fillUpwards(max)
        fillDownwards()
    }

    /** Returns the lowest 32 of the 96 bits for 10^[power]. */
    fun low(power: Int): Long = words[(power - min) * WORDS].toLong() and WORD_MASK

    /** Returns the middle 32 of the 96 bits for 10^[power]. */
    fun middle(power: Int): Long = words[(power - min) * WORDS + 1].toLong() and WORD_MASK

    /** Returns the highest 32 of the 96 bits for 10^[power]; the topmost is always set. */
    fun high(power: Int): Long = words[(power - min) * WORDS + 2].toLong() and WORD_MASK

    /** Powers of five times 2^96, which leaves room for three words below the shortest of them. */
    private fun fillUpwards(max: Int) {
        val number = IntArray(WORDS + wordsOfFive(max))
        number[WORDS] = 1
        keep(number, 0)
        for (power in 1..max) {
            var carry = 0L
            for (i in number.indices) {
                carry += (number[i].toLong() and WORD_MASK) * 5
                number[i] = carry.toInt()
                carry = carry ushr 32
            }
            keep(number, power)
        }
    }

    /**
     * A large power of two divided by ever more fives. Cutting off after each division gives the same as cutting off
     * once at the end.
     */
    private fun fillDownwards() {
        val number = IntArray(WORDS + 1 + wordsOfFive(-min))
        number[number.size - 1] = 1
        for (power in -1 downTo min) {
            var rest = 0L
            for (i in number.indices.reversed()) {
                val part = (rest shl 32) or (number[i].toLong() and WORD_MASK)
                number[i] = (part / 5).toInt()
                rest = part % 5
            }
            keep(number, power)
        }
    }

    private fun keep(number: IntArray, power: Int) {
        var top = number.size - 1
        while (number[top] == 0) top--
        val shift = number[top].countLeadingZeroBits()
        val at = (power - min) * WORDS
        for (i in 0 until WORDS) {
            words[at + i] = shifted(number, top - WORDS + 1 + i, shift)
        }
    }

    private fun shifted(number: IntArray, index: Int, shift: Int): Int =
        if (shift == 0) number[index] else (number[index] shl shift) or (number[index - 1] ushr (32 - shift))

    companion object {
        private const val WORDS = 3
        private const val WORD_MASK = 0xFFFF_FFFFL

        /** Five has 2.33 bits; one spare word does no harm. */
        private fun wordsOfFive(power: Int): Int = power * 233 / 100 / 32 + 1

        /** Returns the largest `n` with `2^n` not above 10^[power], for powers from -1000 to 1000. */
        fun log2Floor(power: Int): Int = (power * 1_741_647) shr 19
    }
}
