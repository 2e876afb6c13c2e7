package badlog.cli.merge

import badlog.catalog.match.MatchMaker
import badlog.cli.command.Outcomes
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.cli.input.readLog
import badlog.files.NotReadException
import badlog.files.UnreadableFileException
import badlog.report.TopicException
import badlog.report.withX
import java.nio.file.Path

/**
 * Reads the logs to merge. Those that cannot be read are reported to [outcomes], and left out.
 *
 * @param xTopic the topic to use as x axis in each log that has rows; null for the log's own.
 */
internal class PartReader(private val console: Console, private val outcomes: Outcomes, private val xTopic: String? = null) {
    /** Whether a log was left out. */
    var hasFailed: Boolean = false
        private set

    /** Returns the logs below [paths]. */
    fun partsOf(paths: List<Path>): List<LogPart> {
        val found = console.searching().use { LogSearch(opensMatches = true, it::next).find(paths) }
        for (failure in found.failures) failed(failure.file, failure.message)
        return found.inputs.mapNotNull(::partOf)
    }

    private fun partOf(input: LogInput): LogPart? {
        val file = input.file
        try {
            val recording = console.progress(file.fileName.toString()).use { readLog(file, it, maker = MatchMaker) }
            val read = if (xTopic != null && recording.format.hasRows) recording.withX(xTopic, file) else recording
            return LogPart(file, read, isMatch = MatchMaker.isSource(file))
        } catch (e: NotReadException) {
            // Something else in a folder is skipped.
            if (!(e.why.isLasting && input.isFound)) hasFailed = true
            outcomes.unreadable(input, e.why.sentence, e.why.isLasting)
        } catch (e: Failure) {
            failed(file, e.message)
        } catch (e: UnreadableFileException) {
            failed(file, e.message)
        } catch (e: TopicException) {
            failed(file, e.message)
        }
        return null
    }

    private fun failed(file: Path, message: String) {
        hasFailed = true
        outcomes.failed(file, message)
    }
}
