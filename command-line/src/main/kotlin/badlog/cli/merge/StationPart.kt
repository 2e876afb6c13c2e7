package badlog.cli.merge

import badlog.cli.cut.samplePart
import badlog.cli.input.Failure
import badlog.cli.station.StationLogs
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Value
import badlog.signals.clock.ClockFit
import badlog.signals.clock.START_VALUE
import badlog.signals.clock.loggedStart
import java.nio.file.Path
import java.time.LocalDateTime
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.util.concurrent.ConcurrentHashMap

/** A Driver Station log that becomes part of a merge, beside the log of [robot], with their clocks aligned by [fit]. */
internal class StationPart(val robot: LogPart, val part: LogPart, val fit: ClockFit) {
    /** Returns it aligned with [moved], the robot's log at its times in the merge; anything before 0 is left out. */
    fun beside(moved: LogPart): LogPart {
        val seconds = fit.seconds + moved.offset
        return part.since(-seconds).later(seconds).withStartOf(moved)
    }
}

/** Finds the Driver Station logs of the same matches as robots' logs. */
internal class StationFinder {
    private val logsIn = ConcurrentHashMap<Path, StationLogs>()

    /**
     * Returns the Driver Station log of the same match as [robot], below [folder].
     *
     * @param acceptsOnly see [badlog.signals.clock.StationSearch.over].
     * @param given other logs that are known to be from that robot.
     * @throws Failure if none can be identified.
     */
    fun of(robot: LogPart, folder: Path, acceptsOnly: Boolean, given: List<Path>): StationPart =
        find(robot, folder, acceptsOnly, given) ?: throw Failure(
            if (logsBelow(folder).size == 0) {
                "No Driver Station log found in $folder; name its folder with --with-ds=FOLDER."
            } else {
                "No Driver Station log in $folder has the time or the match of ${robot.file}; " +
                    "to merge one anyway, name it as a log, with --align enabled."
            },
        )

    /** Returns the same as [of], but null if none can be identified. */
    fun find(robot: LogPart, folder: Path, acceptsOnly: Boolean, given: List<Path> = emptyList()): StationPart? =
        logsBelow(folder).of(clocked(robot), robot.file, acceptsOnly, given)?.let { found ->
            StationPart(robot, LogPart(found.log.path, found.station.recording), found.fit)
        }

    private fun logsBelow(folder: Path) = logsIn.computeIfAbsent(folder, ::StationLogs)
}

/** Returns the same log without its samples before [seconds]. */
internal fun LogPart.since(seconds: Double): LogPart {
    if (!(firstX * secondsPerX < seconds)) return this
    // So that rounding puts nothing before that.
    val span = Span((seconds + ONE_MICRO) / secondsPerX, maxOf(seconds / secondsPerX, lastX))
    return LogPart(file, samplePart(LogView.of(recording), listOf(span)).recording, isOfFile = false)
}

private const val ONE_MICRO = 1e-6

/** Returns this log, moved beside [robot], with the time of day at which its new x is 0. Without it if [robot] has its own. */
private fun LogPart.withStartOf(robot: LogPart): LogPart {
    val start = loggedStart(recording)
    val values = recording.values.mapNotNull { value ->
        when {
            value.name != START_VALUE -> value
            start == null || robot.recording.values.any { it.name == START_VALUE } -> null
            else -> Value(START_VALUE, TIME.format(LocalDateTime.ofEpochSecond((start - offset).toLong(), 0, ZoneOffset.UTC)) + " UTC")
        }
    }
    return with(recording.copy(values = values))
}

private val TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss")
