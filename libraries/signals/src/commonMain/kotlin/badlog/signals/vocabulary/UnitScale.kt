package badlog.signals.vocabulary

import badlog.core.analysis.Units

/** Returns the factor that converts a number in [from] to [to]; null if they do not measure the same thing. */
fun unitScale(from: String, to: String): Double? {
    if (from.equals(to, ignoreCase = true)) return 1.0
    val seconds = Units.secondsIn(from)
    if (seconds != null) return Units.secondsIn(to)?.let { seconds / it }
    val group = UNITS.find { from.lowercase() in it && to.lowercase() in it } ?: return null
    return group.getValue(from.lowercase()) / group.getValue(to.lowercase())
}

/** The unit of a fraction of a whole: 1, not 100, is the whole. */
const val FRACTION = "fraction"

private const val TURN = 360.0

private val UNITS = listOf(
    mapOf("kv" to 1e3, "v" to 1.0, "volt" to 1.0, "volts" to 1.0, "mv" to 1e-3),
    mapOf("a" to 1.0, "amp" to 1.0, "amps" to 1.0, "ampere" to 1.0, "amperes" to 1.0, "ma" to 1e-3),
    mapOf("%" to 1.0, "percent" to 1.0, FRACTION to 100.0),
    mapOf("°c" to 1.0, "c" to 1.0, "degc" to 1.0, "deg c" to 1.0, "celsius" to 1.0),
    mapOf(
        "deg" to 1.0,
        "°" to 1.0,
        "degree" to 1.0,
        "degrees" to 1.0,
        "rad" to TURN / 6.283185307179586,
        "rot" to TURN,
        "rotations" to TURN,
    ),
    mapOf(
        "rpm" to TURN / 60,
        "rot/min" to TURN / 60,
        "rps" to TURN,
        "rot/s" to TURN,
        "rad/s" to TURN / 6.283185307179586,
        "deg/s" to 1.0,
        "°/s" to 1.0,
    ),
    mapOf("m" to 1.0, "meter" to 1.0, "meters" to 1.0, "cm" to 0.01, "mm" to 0.001, "in" to 0.0254, "inches" to 0.0254, "ft" to 0.3048),
    mapOf("m/s" to 1.0, "cm/s" to 0.01, "in/s" to 0.0254, "ft/s" to 0.3048),
    mapOf("m/s²" to 1.0, "m/s^2" to 1.0, "m/s/s" to 1.0, "g" to 9.80665),
    mapOf("psi" to 1.0, "kpa" to 0.145038, "bar" to 14.5038),
    mapOf("mb" to 1.0, "kb" to 1e-3, "b" to 1e-6, "bytes" to 1e-6, "gb" to 1e3),
    mapOf("dbm" to 1.0, "db" to 1.0),
)
