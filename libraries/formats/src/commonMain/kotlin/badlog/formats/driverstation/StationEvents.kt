package badlog.formats.driverstation

import badlog.formats.column.ColumnSource
import badlog.formats.column.SampleColumn
import badlog.formats.column.Timestamps
import badlog.formats.driverstation.Frames.Companion.MORE
import badlog.formats.driverstation.Frames.Companion.NONE
import kotlin.math.abs

/**
 * The entries of a `.dsevents`, each with its time of day and often several messages.
 *
 * @param headerSeconds the whole seconds of the time in the file's header, which is near the times of the entries.
 * @param originSeconds the whole seconds at which x is 0, and [originFraction] their fraction.
 */
internal class StationEvents(
    private val headerSeconds: Double,
    private val originSeconds: Double,
    private val originFraction: Double,
    source: ColumnSource,
) : Frames {
    private class Lane(source: ColumnSource, names: List<String>) {
        val timestamps = Timestamps(source.keepsSamples)
        val columns = source.columns(names.map { FOLDER + it })
    }

    private val events = Lane(source, listOf("Events"))
    private val console = Lane(source, listOf("Console"))
    private val system = Lane(source, SYSTEM.map { it.first })

    /** The match, as reported by the field. */
    val match = StationMatch()

    override fun sizeAt(bytes: ByteArray, at: Int, until: Int, isEnd: Boolean): Int {
        if (until - at < HEADER_SIZE) return MORE
        val size = wordAt(bytes, at + TIME_SIZE)
        val isPossible = wordAt(bytes, at) == 0 && size in 0..MAX_TEXT && isNear(secondsAt(bytes, at), headerSeconds)
        return if (!isPossible) {
            NONE
        } else if (until - at < HEADER_SIZE + size) {
            MORE
        } else {
            HEADER_SIZE + size
        }
    }

    override fun isSure(bytes: ByteArray, at: Int): Boolean = true

    override fun take(bytes: ByteArray, at: Int, size: Int) {
        val time = secondsAt(bytes, at) - originSeconds + (fractionAt(bytes, at) - originFraction)
        val text = bytes.decodeToString(at + HEADER_SIZE, at + size)
        match.handle(text)
        // The newest comes first.
        for (message in text.split("<TagVersion>").asReversed()) handle(time, message)
    }

    private fun handle(time: Double, message: String) {
        if ("<time>" !in message) {
            val split = SPEAKERS.fold(message) { text, speaker -> text.replace(" $speaker", "$END$speaker") }
            split.split(END).forEach { handleUntagged(time, it) }
        } else if ("<details>" in message) {
            val isError = message.between("<flags>", "<Code>").toIntOrNull()?.and(1) == 1
            val code = message.between("<Code>", "<details>")
            val location = message.between("<location>", "<stack>")
            val stack = message.substringAfter("<stack>", "").trimEnd()
            val what = "${if (isError) "ERROR" else "Warning"} $code ${message.between("<details>", "<location>")}"
            add(events, time, what + (if (location.isEmpty()) "" else " at $location") + if (stack.isBlank()) "" else "\n$stack")
        } else {
            add(console, time, message.substringAfter("<message>").substringAfter(' ').trimEnd())
        }
    }

    private fun handleUntagged(time: Double, message: String) {
        val found = SYSTEM_LINE.find(message)
        if (found == null) return add(events, time, message.trim())
        system.timestamps.add(time)
        system.columns.forEachIndexed { i, column -> column.addNumber(found.groupValues[i + 1].toDouble()) }
    }

    private fun add(lane: Lane, time: Double, text: String) {
        if (text.isBlank()) return
        val bytes = text.encodeToByteArray()
        lane.timestamps.add(time)
        lane.columns[0].addText(bytes, 0, bytes.size)
    }

    override fun skip(bytes: Int): Int = 1

    /** Passes each column with its unit and its attributes to [add]. */
    fun topics(add: (SampleColumn, String, List<String>, Timestamps) -> Unit) {
        for (lane in listOf(events, console)) add(lane.columns[0], "", listOf("log"), lane.timestamps)
        system.columns.forEachIndexed { i, column -> add(column, SYSTEM[i].second, emptyList(), system.timestamps) }
    }

    companion object {
        private const val TIME_SIZE = 16

        /** The longest entry seen has 22 kB. */
        private const val MAX_TEXT = 1 shl 20

        /** A month, in s: no Driver Station runs for longer. */
        const val NEAR = 2.7e6

        /** The beginnings of untagged messages. */
        private val SPEAKERS = listOf("Info ", "Warning ", "ERROR ")
        private const val END = "\u0000"

        /** The names and units, in the order of [SYSTEM_LINE]. */
        private val SYSTEM =
            listOf("roboRIO Disk Free" to "MB", "roboRIO Memory Free" to "MB", "Laptop CPU" to "%", "Laptop Battery" to "%")
        private val SYSTEM_LINE = Regex("Disk Free (\\d+) MB, Memory Free (\\d+) MB\\. DS Laptop: CPU (\\d+)% Batt (\\d+)%")

        /** Returns whether times of [one] and [other] seconds may belong to the same run of the Driver Station. */
        fun isNear(one: Double, other: Double): Boolean = abs(one - other) < NEAR

        private fun String.between(start: String, end: String) = substringAfter(start, "").substringBefore(end).trim()
    }
}
