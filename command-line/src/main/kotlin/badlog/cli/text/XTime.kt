package badlog.cli.text

import badlog.recording.Topic

/** What the unit of an x axis says about time. */
internal object XTime {
    private val SECONDS = mapOf(
        "s" to 1.0, "sec" to 1.0, "second" to 1.0, "seconds" to 1.0,
        "ms" to 1e-3, "us" to 1e-6, "µs" to 1e-6, "μs" to 1e-6, "ns" to 1e-9, "min" to 60.0, "h" to 3600.0,
    )

    /** How many seconds one [unit] is, or null when it is none of time. */
    fun secondsPer(unit: String): Double? = SECONDS[unit.trim().lowercase()]

    /** [position] in [unit], as a person reads it. */
    fun text(position: Double, unit: String): String =
        shortNumber(position) + if (unit.isEmpty() || unit == Topic.UNITLESS) "" else " $unit"

    /** [seconds] as minutes and seconds, `1:32.5`, or from an hour on as `1:20:05`. */
    fun clock(seconds: Double): String {
        val tenths = Math.round(seconds * 10)
        val whole = tenths / 10
        val minutes = whole / 60
        if (minutes < 60) return "$minutes:${twoDigits(whole % 60)}.${tenths % 10}"
        return "${minutes / 60}:${twoDigits(minutes % 60)}:${twoDigits(whole % 60)}"
    }

    private fun twoDigits(number: Long) = number.toString().padStart(2, '0')
}
