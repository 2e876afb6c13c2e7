package badlog.rules

import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** Builds the texts of [rule] about [question] in a log that was read from [file] and is of [match]. */
internal class TextedRule(
    private val rule: Rule,
    private val question: RuleProgram.Question,
    private val match: String,
    private val file: String,
    private val timeUnit: String,
) {
    /**
     * Returns the text for [value] at [time], found [count] times, over a total [length] of time in which [channels] drew most, each with
     * its current.
     */
    fun text(value: String, time: Double, count: Int, length: Double, channels: List<String> = emptyList()): String = rule.text.filled(
        mapOf(
            "value" to value,
            "time" to timeText(time, timeUnit),
            "match" to match,
            "file" to file,
            "topic" to question.topic.orEmpty(),
            "other" to question.other.orEmpty(),
            "device" to question.device,
            "count" to count.toString(),
            "duration" to timeText(roundedLength(length), timeUnit),
            "channels" to if (channels.isEmpty()) "" else "; most by ${channels.joinToString()}",
        ),
    )
}

/** Returns [length] with as many digits as are useful for a duration. */
private fun roundedLength(length: Double): Double {
    if (!(length > 0 && length.isFinite())) return length
    val places = 10.0.pow(LENGTH_DIGITS - 1 - floor(log10(length)).toInt())
    return round(length * places) / places
}

private const val LENGTH_DIGITS = 3
