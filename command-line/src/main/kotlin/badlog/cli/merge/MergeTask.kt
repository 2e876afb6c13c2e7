package badlog.cli.merge

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.output.OutputPlan
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
            val logs = PartReader(console, outcomes, xTopic).partsOf(paths)
            outcomes.done(target, console.progress(target.fileName.toString()).use { merging.write(logs, target, it) }.outcome)
        } catch (e: Throwable) {
            outcomes.failed(out, LogLoop.sentenceOf(e, out))
        }
        return outcomes.end()
    }
}
