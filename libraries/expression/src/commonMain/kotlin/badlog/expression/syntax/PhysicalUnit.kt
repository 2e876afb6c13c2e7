package badlog.expression.syntax

import badlog.core.analysis.Units
import badlog.core.text.isLetter
import badlog.core.text.isLetterOrDigit
import kotlin.math.abs
import kotlin.math.round

/**
 * The quantity that a unit measures, and its size.
 *
 * @property dimension the kind of quantity; only numbers of the same dimension can be compared.
 * @property size its size in the dimension's base unit.
 * @property axisPower the power of the x axis' unit of time that it also contains.
 */
internal class PhysicalUnit(val dimension: String, val size: Double, val axisPower: Int = 0) {
    /** Returns this unit divided by the unit of x. */
    fun perAxis() = PhysicalUnit(if (dimension.endsWith(TIMES)) dimension.removeSuffix(TIMES) else "$dimension$PER", size, axisPower - 1)

    /** Returns this unit multiplied by the unit of x. */
    fun timesAxis() = PhysicalUnit(if (dimension.endsWith(PER)) dimension.removeSuffix(PER) else "$dimension$TIMES", size, axisPower + 1)

    companion object {
        private const val PER = "/time"
        private const val TIMES = "·time"

        /** The unit of the x axis. */
        val AXIS: PhysicalUnit = PhysicalUnit("time", 1.0, axisPower = 1)

        /** Returns the unit called [unit]; null if it is not known. */
        fun of(unit: String): PhysicalUnit? =
            Units.secondsIn(unit)?.let { PhysicalUnit("time", it) } ?: KNOWN[unit] ?: KNOWN[unit.lowercase()]

        /** Returns the longest unit at [from] in [text] that ends at a word boundary; empty if there is none. */
        fun longestAt(text: String, from: Int): String {
            var until = from
            while (until < text.length && until - from < MAX_LENGTH && (isLetter(text[until]) || text[until] in OF_UNITS)) until++
            while (until > from) {
                val isEnd = until == text.length || !(isLetterOrDigit(text[until]) || text[until] == '_') || text[until - 1] == '²'
                if (isEnd && of(text.substring(from, until)) != null) return text.substring(from, until)
                until--
            }
            return ""
        }

        private const val OF_UNITS = "/°²·"
        private const val MAX_LENGTH = 16

        private const val TURN = 360.0
        private const val RADIAN = 57.29577951308232
        private const val INCH = 0.0254
        private const val FOOT = 0.3048

        private val KNOWN: Map<String, PhysicalUnit> = buildMap {
            fun add(dimension: String, vararg units: Pair<String, Double>) {
                for ((names, size) in units) for (name in names.split(' ')) put(name, PhysicalUnit(dimension, size))
            }
            add("voltage", "V volt volts" to 1.0, "mV" to 1e-3, "kV" to 1e3)
            add("current", "A amp amps ampere amperes" to 1.0, "mA" to 1e-3)
            add("power", "W watt watts" to 1.0, "mW" to 1e-3, "kW" to 1e3)
            add("energy", "J joule joules" to 1.0, "kJ" to 1e3, "Wh" to 3600.0)
            add("current·time", "Ah" to 3600.0, "A·s As" to 1.0, "mAh" to 3.6)
            val lengths = listOf(
                "m" to 1.0,
                "meter meters metre metres" to 1.0,
                "cm" to 1e-2,
                "mm" to 1e-3,
                "in inch inches" to INCH,
                "ft feet" to FOOT,
            )
            val angles = listOf(
                "deg ° degree degrees" to 1.0,
                "rad radian radians" to RADIAN,
                "rot rotation rotations rev revolutions" to TURN,
            )
            add("length", *lengths.toTypedArray())
            add("angle", *angles.toTypedArray())
            for ((dimension, units) in listOf("length" to lengths, "angle" to angles)) {
                for ((names, size) in units) {
                    for (name in names.split(' ')) {
                        put("$name/s", PhysicalUnit("$dimension/time", size))
                        for (squared in listOf(
                            "$name/s²",
                            "$name/s^2",
                            "$name/s/s",
                        )) {
                            put(squared, PhysicalUnit("$dimension/time/time", size))
                        }
                    }
                }
            }
            add("angle/time", "rpm RPM" to TURN / 60, "rps RPS" to TURN)
            add("temperature", "°C C celsius degC" to 1.0)
            add("share", "% percent" to 1e-2, "fraction" to 1.0)
            add("frequency", "Hz" to 1.0, "kHz" to 1e3)
            add("pressure", "psi PSI" to 1.0, "bar" to 14.503773773)
        }
    }
}

/** Converts numbers in [from] to numbers in [to], which has the same dimension and is called [unit]. */
internal class Conversion(private val from: PhysicalUnit, private val to: PhysicalUnit, val unit: String) {
    /** Returns the factor of the conversion if a second has the length [perSecond] on x. */
    fun factor(perSecond: Double): Double {
        var factor = from.size / to.size
        repeat(abs(from.axisPower - to.axisPower)) { if (from.axisPower > to.axisPower) factor /= perSecond else factor *= perSecond }
        return when {
            // A factor that is exact in decimals stays exact.
            isNearly(factor, round(factor)) -> round(factor)

            isNearly(1 / factor, round(1 / factor)) -> 1 / round(1 / factor)

            else -> factor
        }
    }

    private fun isNearly(number: Double, whole: Double) = whole != 0.0 && abs(number - whole) < whole * 1e-12
}
