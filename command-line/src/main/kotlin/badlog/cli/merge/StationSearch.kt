package badlog.cli.merge

import badlog.cli.input.Failure
import badlog.cli.search.signalsBeside
import badlog.file.FolderScan
import badlog.file.LogName
import badlog.file.readRecording
import badlog.file.reading
import badlog.formats.LOG_FORMATS
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Value
import badlog.rules.signal.matchOf
import java.nio.file.Path
import java.time.DateTimeException
import java.time.LocalDateTime
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter

/**
 * Finds the Driver Station log of the match that [robot] is the log of, below [folder]: by the time of day, or else by the match. Clocks
 * of robots are often wrong, so where neither tells it, the only one that there is will do.
 */
internal class StationSearch(private val robot: LogPart, private val folder: Path) {
    private class Station(val part: LogPart, val start: Double?)

    /**
     * The log.
     *
     * @throws Failure when none can be told to be it.
     */
    fun found(): LogPart {
        val stations = stations()
        if (stations.isEmpty()) throw Failure("There is no Driver Station log below $folder; name its folder by --with-ds=FOLDER.")
        return byTime(stations) ?: byMatch(stations) ?: stations.singleOrNull()?.part ?: throw Failure(
            "None of the ${stations.size} Driver Station logs below $folder is of the time or the match of ${robot.file}; " +
                "name the one that is as a log to merge, with --align enabled.",
        )
    }

    private fun stations(): List<Station> = reading(folder) { FolderScan.of(folder) }.files
        .filter { it.path != robot.file && LogName.of(it.name).ending.lowercase() in ENDINGS }
        .map { it.path to readRecording(it.path, LOG_FORMATS) }
        .filter { (_, recording) -> recording.format == RecordingFormat.DRIVER_STATION && recording.sampleCount > 0 }
        .map { (file, recording) -> Station(LogPart(file, recording), startIn(recording)) }

    /** The one that has the most of the time in which the robot's log was made. */
    private fun byTime(stations: List<Station>): LogPart? {
        val start = startOf(robot) ?: return null
        val from = start + robot.firstX * robot.secondsPerX
        val until = start + robot.lastX * robot.secondsPerX
        fun common(station: Station): Double =
            station.start?.let { minOf(until, it + station.part.lastX) - maxOf(from, it + station.part.firstX) } ?: 0.0
        return stations.filter { common(it) > 0 }.maxByOrNull(::common)?.part
    }

    private fun byMatch(stations: List<Station>): LogPart? {
        fun matchIn(part: LogPart) = signalsBeside(part.file).matchOf(part.recording).run { if (number == null) null else type to number }
        val match = matchIn(robot) ?: return null
        return stations.filter { matchIn(it.part) == match }.map { it.part }.singleOrNull()
    }

    private companion object {
        val ENDINGS = setOf(".dslog", ".dsevents")
    }
}

/** By how many seconds [station] is to be moved to the time of [robot], as the clocks of both tell; null where one does not. */
internal fun offsetByClocks(station: LogPart, robot: LogPart): Double? {
    val start = startIn(station.recording) ?: return null
    return startOf(robot)?.let { start - it }
}

/** [station], which was moved beside [robot], with the time of day at which x is 0 now; without it where [robot] has its own. */
internal fun withStartOf(robot: LogPart, station: LogPart): LogPart {
    val start = startIn(station.recording)
    val values = station.recording.values.mapNotNull { value ->
        when {
            value.name != START -> value
            start == null || robot.recording.values.any { it.name == START } -> null
            else -> Value(START, TIME.format(LocalDateTime.ofEpochSecond((start - station.offset).toLong(), 0, ZoneOffset.UTC)) + UTC)
        }
    }
    return LogPart(station.file, station.recording.copy(values = values), station.offset)
}

/** When x was 0, in s since 1970, as the log of the robot or its name tells; null where neither does. */
private fun startOf(robot: LogPart): Double? {
    val logged = startIn(robot.recording)
    // What is logged is the time of the first sample.
    if (logged != null) return logged - if (robot.firstX.isNaN()) 0.0 else robot.firstX * robot.secondsPerX
    val name = NAMED.find(robot.file.fileName.toString()) ?: return null
    return secondOf(name.value, NAMED_TIME)
}

private fun startIn(recording: Recording): Double? =
    recording.values.find { it.name == START && it.text.endsWith(UTC) }?.let { secondOf(it.text.removeSuffix(UTC), TIME) }

private fun secondOf(text: String, format: DateTimeFormatter): Double? = try {
    LocalDateTime.parse(text, format).toEpochSecond(ZoneOffset.UTC).toDouble()
} catch (_: DateTimeException) {
    null
}

private const val START = "Start Time"
private const val UTC = " UTC"
private val TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss")

/** As WPILib names its logs: in UTC. */
private val NAMED = Regex("(?<!\\d)\\d{8}_\\d{6}(?!\\d)")
private val NAMED_TIME = DateTimeFormatter.ofPattern("yyyyMMdd_HHmmss")
