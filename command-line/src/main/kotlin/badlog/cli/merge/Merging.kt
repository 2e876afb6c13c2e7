package badlog.cli.merge

import badlog.catalog.match.FileForZip
import badlog.catalog.match.writeMatchZip
import badlog.cli.command.Outcome
import badlog.cli.input.Failure
import badlog.cli.output.LogFormat
import badlog.cli.output.writeLog
import badlog.files.isOfDriverStation
import badlog.files.terminal.Progress
import badlog.files.writeAtomically
import badlog.signals.match.files.FileRole
import java.nio.file.Path

/**
 * How several logs become one.
 *
 * @param station the folder to search for the Driver Station log of the robot's log, which is put beside it; empty for the log's own
 *   folder, null for none.
 * @param acceptsOnly whether that is the only one there is, whatever its clock, since a person named a single match.
 */
internal class Merging(
    private val mode: MergeMode,
    private val clocks: ClockChoice,
    private val station: Path?,
    private val acceptsOnly: Boolean,
) {
    /**
     * Writes one log of [logs], in whatever order they are, to [target].
     *
     * @throws Failure if they cannot become one.
     */
    fun write(logs: List<LogPart>, target: Path, progress: Progress): Outcome {
        val sorted = logs.sortedWith(PART_ORDER)
        val robot = sorted.firstOrNull()
        val beside = if (station == null || robot == null) null else StationPart.of(robot, folderBeside(robot.file, station), acceptsOnly)
        val parts = sorted + listOfNotNull(beside?.part)
        if (parts.size < 2) throw Failure("Merging needs at least two logs, but there is ${if (parts.isEmpty()) "none" else "one"}.")
        val moved = clocks.moved(parts, beside)
        return if (isZip(target)) zipped(moved, target) else merge(moved, target, progress)
    }

    /** Whether a Driver Station's log of the match of [log] is found. */
    fun hasStation(log: LogPart): Boolean = station != null && StationPart.find(log, folderBeside(log.file, station), acceptsOnly) != null

    /** Topics keep times of their own if one log has them, or the result can. */
    private fun merge(moved: MovedLogs, target: Path, progress: Progress): Outcome {
        val parts = moved.parts
        val wanted = LogFormat.ofName(target)
        if (parts.all { it.hasRows } && wanted?.hasRows != false) {
            val merged = Merge(parts, mode).merged()
            val format = wanted ?: LogFormat.of(merged.recording)
            return mergeOutcome(merged, moved, target, writeLog(merged.recording, format, target, progress = progress))
        }
        parts.find { !it.hasRows }?.let { wanted?.require(it.recording, target) }
        val records = MergedRecords(parts.map { it.withOwnTimes() }, mode)
        val merged = records.write(target, progress)
        return mergeOutcome(merged, moved, target, records.leftOut)
    }

    /** The files stay as they are; their clocks are stated beside them, that of the first being the match's. */
    private fun zipped(moved: MovedLogs, target: Path): Outcome {
        val own = moved.parts.first().offset
        val errors = moved.moves.associate { it.part to it.error.takeIf { _ -> it.edges > 0 } }
        val files = moved.parts.map { FileForZip(it.file, roleOf(it), it.offset - own, errors[it]) }
        writeAtomically(target) { writeMatchZip(files, it) }
        return zipOutcome(moved, target)
    }

    private fun roleOf(part: LogPart): FileRole = when {
        part.recording.isOfDriverStation -> FileRole.STATION
        isOfMotors(part) -> FileRole.MOTORS
        part.file.toString().endsWith(".hoot", ignoreCase = true) -> FileRole.CAN_BUS
        else -> FileRole.ROBOT
    }
}

/** Returns [folder], or that of [log] if it is empty. */
internal fun folderBeside(log: Path, folder: Path): Path = if (folder.toString().isEmpty()) log.toAbsolutePath().parent else folder

/** Whether [target] is to be a ZIP of the logs as they are. */
internal fun isZip(target: Path): Boolean = target.toString().endsWith(".zip", ignoreCase = true)
