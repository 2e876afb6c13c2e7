package badlog.core.bag

import badlog.core.recording.Recording
import kotlin.random.Random

/** The pieces of good and broken bags: they find far more mistakes than random bytes alone. */
internal val FRAGMENTS = listOf(
    "1", "-2.5", "1e5", "12.346", "abc", "\"", "\"\"", ",", ",", ",", "\n", "\n", "\r", "\r\n", "\u0000", "\u0000\u0000",
    "true", "NaN", "null", "\"1,5\"", "\"a,b\"", " ", "Ω", "{", "}", "[",
)

private val CELLS = listOf(
    "1", "-2.5", "12.346", "1e5", "123456789.123", "", "", "true", "false", "NaN", "inf", "null", "LOW", "HIGH", "Ω ready",
    "\"a,b\"", "\"said \"\"go\"\"\"", "\"1,5\"", "\"two\nlines\"", "a longer text that nobody has said before",
)

private const val HEADER = "{\"topics\":[{\"name\":\"a\"},{\"name\":\"b\"},{\"name\":\"c\",\"attrs\":[\"log\"]}]}\na,b,c\n"

/** Returns a bag with a bit of everything, and something odd in a few rows. Some are cut, or in Latin-1. */
internal fun randomBag(random: Random): ByteArray {
    val rows = List(random.nextInt(0, 40)) {
        val row = List(3) { CELLS.random(random) }.joinToString(",")
        val ending = if (random.nextInt(40) == 0) "\r\n" else "\n"
        when (random.nextInt(60)) {
            0 -> List(random.nextInt(0, 8)) { FRAGMENTS.random(random) }.joinToString("") + ending
            1 -> row + "\u0000\u0000" + ending
            2 -> "1,2,caf\u00E9$ending"
            3 -> row
            else -> row + ending
        }
    }
    val text = HEADER + rows.joinToString("")
    val end = if (random.nextInt(5) == 0) text.length - random.nextInt(1, 9) else text.length
    return if ('\u00E9' in text) ByteArray(end) { text[it].code.toByte() } else text.substring(0, end).encodeToByteArray()
}

/** Returns [describe] with the details that it leaves out: the bits of numbers, and the order of the dictionaries. */
internal fun describeFully(recording: Recording): String = describe(recording) + recording.topics.joinToString("\n") { topic ->
    "${topic.name} ${topic.texts.dictionary} ${topic.samples.map { it.toRawBits().toString(16) }}"
}
