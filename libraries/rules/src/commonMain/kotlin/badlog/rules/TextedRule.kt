package badlog.rules

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** Builds the texts of [rule] for [question] in the log [file], recorded in [match]. [devices] holds the team's names. */
internal class TextedRule(
    private val rule: Rule,
    private val question: RuleProgram.Question,
    private val match: String,
    private val file: String,
    private val timeUnit: String,
    private val devices: DeviceNames,
) {
    /** The text for something found once. */
    private val once: RuleText by lazy { ONCE.fold(rule.text) { text, (counted, single) -> text.replacing(counted, single) } }

    /**
     * Returns the text for [value] at [time], found [count] times, for a total duration of [length]. [channels] are the channels that drew
     * most current then, each with its current. [meanwhile] are the events at the same time.
     */
    fun text(
        value: String,
        time: Double,
        count: Int,
        length: Double,
        channels: List<String> = emptyList(),
        meanwhile: List<String> = emptyList(),
    ): String {
        val text = if (count == 1) once else rule.text
        return text.filled(
            mapOf(
                "value" to value,
                "time" to timeText(if (timeUnit == "s") round(time * MILLI) / MILLI else time, timeUnit),
                "match" to match,
                "file" to file,
                "topic" to devices.topicText(question.topic.orEmpty()),
                "other" to devices.topicText(question.other.orEmpty()),
                "device" to devices.deviceText(question.device),
                "count" to count.toString(),
                "duration" to timeText(rounded(length, LENGTH_DIGITS), timeUnit),
                "channels" to if (channels.isEmpty()) "" else "; most by ${channels.joinToString()}",
                "meanwhile" to if (meanwhile.isEmpty()) "" else "; at the same time, ${meanwhile.joinToString(" and ")}",
            ),
        )
    }
}

/**
 * Returns [value], rounded to the precision that a sentence about a measurement needs. A whole number, which may be a count, is exact.
 * Robots measure currents to an eighth of an ampere at best, and voltages to a hundredth of a volt.
 */
internal fun roundedForText(value: Double, unit: String): Double = when {
    value == round(value) -> value
    unit == "A" || (unit == "V" && abs(value) < 10) -> rounded(value, VALUE_DIGITS - 1)
    else -> rounded(value, VALUE_DIGITS)
}

/** Returns [value] with [digits] significant digits. */
private fun rounded(value: Double, digits: Int): Double {
    if (value == 0.0 || !value.isFinite()) return value
    val power = digits - 1 - floor(log10(abs(value))).toInt()
    // A power below 1 is not exact, and would leave digits behind.
    return if (power < 0) 10.0.pow(-power).let { round(value / it) * it } else 10.0.pow(power).let { round(value * it) / it }
}

/** The phrase for a number of times, and its replacement for a single time. */
private val ONCE = listOf(" ({count}×)" to "", "({count}× " to "(")
private const val LENGTH_DIGITS = 3
private const val VALUE_DIGITS = 4
private const val MILLI = 1000
