package badlog.cli.merge

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.cli.input.readLog
import badlog.cli.output.LogFormat
import badlog.cli.output.OutputPlan
import badlog.cli.output.writeLog
import badlog.files.NotReadException
import badlog.files.terminal.Progress
import badlog.report.TopicException
import badlog.report.withX
import java.nio.file.Path

/**
 * Merges several logs into one, [out].
 *
 * @param station the folder to search for the Driver Station log of the robot's log, which is put beside it; empty for the log's own
 *   folder, null for none.
 */
internal class MergeTask(
    private val paths: List<Path>,
    private val mode: MergeMode,
    private val out: Path,
    private val plan: OutputPlan,
    private val xTopic: String?,
    private val clocks: ClockChoice,
    private val station: Path?,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("merge", console, isJson)
        try {
            // Checked before any work, so that nobody waits in vain.
            val target = plan.checked(out)
            val found = console.searching().use { LogSearch(it::next).find(paths) }
            for (failure in found.failures) outcomes.failed(failure.file, failure.message)
            val logs = found.inputs.mapNotNull { read(it, console, outcomes) }.sortedWith(PART_ORDER)
            val beside = if (station == null || logs.isEmpty()) null else stationOf(logs.first(), station)
            val parts = logs + listOfNotNull(beside?.part)
            if (parts.size < 2) {
                throw Failure("Merging needs at least two logs, but there is ${if (parts.isEmpty()) "none" else "one"}.")
            }
            outcomes.done(target, console.progress(target.fileName.toString()).use { merge(clocks.moved(parts, beside), target, it) })
        } catch (e: Throwable) {
            outcomes.failed(out, LogLoop.sentenceOf(e, out))
        }
        return outcomes.end()
    }

    private fun stationOf(robot: LogPart, folder: Path): StationPart {
        val beside = robot.file.toAbsolutePath().parent
        return StationPart.of(robot, if (folder.toString().isEmpty()) beside else folder)
    }

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

    private fun read(input: LogInput, console: Console, outcomes: Outcomes): LogPart? {
        try {
            val recording = console.progress(input.file.fileName.toString()).use { readLog(input.file, it) }
            val needsX = xTopic != null && recording.format.hasRows
            return LogPart(input.file, if (needsX) recording.withX(checkNotNull(xTopic), input.file) else recording)
        } catch (e: NotReadException) {
            outcomes.unreadable(input, e.why.sentence, e.why.isLasting)
        } catch (e: Failure) {
            outcomes.failed(input.file, e.message)
        } catch (e: TopicException) {
            outcomes.failed(input.file, e.message)
        }
        return null
    }
}
