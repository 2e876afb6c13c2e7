package badlog.cli.merge

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.cli.input.readLog
import badlog.cli.output.OutputPlan
import badlog.files.NotReadException
import badlog.report.TopicException
import badlog.report.withX
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
            // Checked before any work, so that nobody waits in vain.
            val target = plan.checked(out)
            val found = console.searching().use { LogSearch(checkpoint = it::next).find(paths) }
            for (failure in found.failures) outcomes.failed(failure.file, failure.message)
            val logs = found.inputs.mapNotNull { read(it, console, outcomes) }
            outcomes.done(target, console.progress(target.fileName.toString()).use { merging.write(logs, target, it) })
        } catch (e: Throwable) {
            outcomes.failed(out, LogLoop.sentenceOf(e, out))
        }
        return outcomes.end()
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
