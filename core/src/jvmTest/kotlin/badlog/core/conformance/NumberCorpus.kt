package badlog.core.conformance

import badlog.core.number.EXACT_POWERS_OF_TEN
import badlog.core.number.FiveDigitFormat
import kotlin.math.nextDown
import kotlin.math.nextUp
import kotlin.math.pow

/** The file of the corpus with the texts of numbers. */
internal const val NUMBER_CORPUS = "numbers/five-digits.txt"

/**
 * Doubles by their bits, with the text that a writer of bags gives them. For very many doubles, digests of the texts.
 */
internal fun numberCorpus(): String = buildString {
    for (value in namedNumbers()) append(value.toRawBits().toULong().toString(16).padStart(16, '0')).append(' ').append(textOf(value)).append('\n')
    for (kind in NumberKind.entries) {
        for (seed in 1L..DIGESTS) append("digest ${kind.label} $seed $DIGEST_COUNT ${digest(kind, seed)}\n")
    }
}

private const val DIGESTS = 2L
private const val DIGEST_COUNT = 500_000

private fun namedNumbers(): Sequence<Double> = sequence {
    yieldAll(listOf(0.0, -0.0, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.MAX_VALUE, -Double.MIN_VALUE))
    yieldAll(listOf(12.3456, -12.3456, 2.00005, 1.55565, 1.5556499999999998, 99999.4, 99999.5, 9.99994e-5, 9.99995e-5, 3.77845e-250))
    yieldAll(listOf(2.9514790517935283e20, 3.2402499999999997e20, 1.0000499999999999e21, 1.7854999999999999e266, 4.08305e157, 6.2745e51))
    for (exponent in -1074..1023) yield(2.0.pow(exponent))
    for (exponent in -323..308) {
        for (text in listOf("1e$exponent", "99999e${exponent - 5}", "999995e${exponent - 6}")) {
            val value = text.toDouble()
            if (value > 0) yieldAll(listOf(value.nextDown(), value, value.nextUp()))
        }
    }
    for (units in 1L..300L) yield(Double.fromBits(units))
}

/** The doubles of a digest, made of the bits that splitmix64 gives. */
private enum class NumberKind(val label: String, val valueOf: (ULong) -> Double) {
    BITS("bits", { Double.fromBits(it.toLong()) }),
    SUBNORMALS("subnormals", { Double.fromBits(((it and 0xFFFFFFFFFFFFFuL) shr ((it shr 58) % 52u).toInt()).toLong()) }),
    TIES("ties", ::tie),
    NEAR_TIES("near-ties", { Double.fromBits(tie(it).toRawBits() + ((it shr 40) % 5u).toLong() - 2) }),
}

private fun tie(bits: ULong): Double = ((bits % 90_000u).toDouble() * 10 + 100_005) / EXACT_POWERS_OF_TEN[(bits shr 60).toInt()]

/** FNV-1a of the texts, each followed by a newline. */
private fun digest(kind: NumberKind, seed: Long): String {
    val buffer = ByteArray(FiveDigitFormat.MAX_LENGTH + 1)
    var state = seed.toULong()
    var hash = 0xCBF29CE484222325uL
    repeat(DIGEST_COUNT) {
        state += 0x9E3779B97F4A7C15uL
        var bits = state
        bits = (bits xor (bits shr 30)) * 0xBF58476D1CE4E5B9uL
        bits = (bits xor (bits shr 27)) * 0x94D049BB133111EBuL
        bits = bits xor (bits shr 31)
        val end = FiveDigitFormat.write(kind.valueOf(bits), buffer, 0)
        buffer[end] = '\n'.code.toByte()
        for (i in 0..end) hash = (hash xor buffer[i].toUByte().toULong()) * 0x100000001B3uL
    }
    return hash.toString(16).padStart(16, '0')
}

private fun textOf(value: Double): String {
    val buffer = ByteArray(FiveDigitFormat.MAX_LENGTH)
    return buffer.decodeToString(0, FiveDigitFormat.write(value, buffer, 0))
}
