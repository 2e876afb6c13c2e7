package badlog.cli.text

import badlog.recording.Topic

/** Positions and lengths on an x axis, as a person reads them. */
internal object XTime {
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
