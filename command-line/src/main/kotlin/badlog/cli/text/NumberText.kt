package badlog.cli.text

import badlog.core.analysis.Units
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.abs

/** Returns [number] for people: at most [digits] significant digits, without trailing zeros; empty for NaN. */
internal fun shortNumber(number: Double, digits: Int = DIGITS): String = when {
    number.isNaN() -> ""

    number.isInfinite() -> if (number > 0) "Infinity" else "-Infinity"

    number == 0.0 -> "0"

    else -> {
        val rounded = BigDecimal(number).round(MathContext(digits)).stripTrailingZeros()
        if (abs(number) in PLAIN_FROM..PLAIN_TO) rounded.toPlainString() else rounded.toString().lowercase()
    }
}

/** Returns [count] in groups of three digits, separated by commas. */
internal fun grouped(count: Long): String = count.toString().reversed().chunked(3).joinToString(",").reversed()

/** Returns [count] with its noun; [noun] is the singular. */
internal fun counted(count: Long, noun: String, nouns: String = noun + "s"): String =
    "${grouped(count)} ${if (count == 1L) noun else nouns}"

/** Returns [bytes] as file managers show them. */
internal fun sizeText(bytes: Long): String = when {
    bytes < 1_000 -> counted(bytes, "byte")
    bytes < 1_000_000 -> "${shortNumber(bytes / 100 / 10.0)} kB"
    bytes < 1_000_000_000 -> "${shortNumber(bytes / 100_000 / 10.0)} MB"
    else -> "${shortNumber(bytes / 100_000_000 / 10.0)} GB"
}

private const val DIGITS = 6
private const val PLAIN_FROM = 1e-4
private const val PLAIN_TO = 1e9

/** Positions and lengths on an x axis, for people. */
internal object XTime {
    /** Returns [position] in [unit], for people. */
    fun text(position: Double, unit: String): String = shortNumber(position) + if (Units.isNone(unit)) "" else " $unit"

    /** Returns [seconds] as minutes and seconds, `1:32.5`, or from an hour on as `1:20:05`. */
    fun clock(seconds: Double): String {
        val tenths = Math.round(seconds * 10)
        val whole = tenths / 10
        val minutes = whole / 60
        if (minutes < 60) return "$minutes:${twoDigits(whole % 60)}.${tenths % 10}"
        return "${minutes / 60}:${twoDigits(minutes % 60)}:${twoDigits(whole % 60)}"
    }

    private fun twoDigits(number: Long) = number.toString().padStart(2, '0')
}
