package badlog.cli.merge

import badlog.cli.beside.FilesBeside
import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.output.OutputPlan
import badlog.signals.match.files.FileRole
import java.nio.file.Path

/** Merges several logs into one, [out], as [merging] says. */
internal class MergeTask(
    private val paths: List<Path>,
    private val merging: Merging,
    private val out: Path,
    private val plan: OutputPlan,
    private val xTopic: String?,
    private val isJson: Boolean,
) : Task {
    override fun run(console: Console): ExitCode {
        val outcomes = Outcomes("merge", console, isJson)
        try {
            // Checked before any work, to save a useless wait.
            val target = plan.checked(out)
            val reader = PartReader(console, outcomes, xTopic)
            val logs = reader.partsOf(paths)
            val near = if (merging.findsMore && isZip(target)) reader.partsOf(logsNear(logs)) else emptyList()
            outcomes.done(target, console.progress(target.fileName.toString()).use { merging.write(logs, target, it, near) }.outcome)
        } catch (e: Throwable) {
            outcomes.failed(out, LogLoop.sentenceOf(e, out))
        }
        return outcomes.end()
    }

    /** Returns the logs of devices near robots' logs among [logs], with names of the same match. */
    private fun logsNear(logs: List<LogPart>): List<Path> {
        val beside = FilesBeside()
        val found = logs.filter { it.role == FileRole.ROBOT && !it.isMatch }.flatMap { robot ->
            val folder = robot.file.toAbsolutePath().normalize().parent
            beside.of(robot.file, clocked(robot)).filter { it.isLog }.map { folder.resolve(it.path).normalize() }
        }
        return found.distinct() - logs.mapTo(HashSet()) { it.file.toAbsolutePath().normalize() }
    }
}
