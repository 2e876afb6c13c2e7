package badlog.cli.command

import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.exporter.ExportException
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.files.UnwritableFileException
import badlog.files.terminal.Progress
import java.nio.file.Path

/**
 * Processes many logs one at a time, so that memory is bounded by the largest. A failure does not affect the others.
 *
 * @param isJson whether each log is one line of JSON.
 * @param opensMatches whether a folder with a `match.json` is one log.
 */
internal class LogLoop(command: String, private val console: Console, isJson: Boolean, private val opensMatches: Boolean = false) {
    private val outcomes = Outcomes(command, console, isJson, isSummed = true)

    /** Does [work] on every log below [paths], in order, and reports the outcomes. */
    fun run(paths: List<Path>, work: (LogInput, Progress) -> Outcome): ExitCode {
        val found = console.searching().use { LogSearch(opensMatches, it::next).find(paths) }
        for (failure in found.failures) outcomes.failed(failure.file, failure.message)
        for ((index, input) in found.inputs.withIndex()) {
            // Nobody would read the results of the others.
            if (console.isOutClosed) break
            val label = (if (found.inputs.size > 1) "${index + 1}/${found.inputs.size} " else "") + input.file.fileName
            attempt(input, label, work)
        }
        return outcomes.end()
    }

    private fun attempt(input: LogInput, label: String, work: (LogInput, Progress) -> Outcome) {
        val file = input.file
        try {
            outcomes.done(file, console.progress(label).use { work(input, it) })
        } catch (e: NotReadException) {
            outcomes.unreadable(input, e.why.sentence, e.why.isLasting)
        } catch (e: Throwable) {
            outcomes.failed(file, sentenceOf(e, file))
        }
    }

    companion object {
        /** Returns the sentence about [failure], which ended the work on [file]. */
        fun sentenceOf(failure: Throwable, file: Path): String = when (failure) {
            is Failure -> failure.message
            is UnwritableFileException -> failure.message
            is ExportException -> failure.message.orEmpty()
            else -> ReadResult.NotRead.of(file, failure).sentence
        }
    }
}
