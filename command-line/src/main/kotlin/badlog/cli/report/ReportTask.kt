package badlog.cli.report

import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.Task
import badlog.cli.analysis.Search
import badlog.cli.analysis.SearchException
import badlog.cli.input.logFiles
import badlog.html.ExportException
import badlog.report.LogReport
import badlog.report.ReportResult
import badlog.report.hook.HookOutcome
import badlog.report.page.ReportFolder
import badlog.report.reportCsv
import badlog.report.reportJson
import badlog.report.reportText
import badlog.report.rules.RuleSet
import java.io.IOException
import java.nio.file.Path

/**
 * Looks for something in every log below [paths].
 *
 * @param search what to look for.
 * @param folder where pages and their index go; null for none.
 * @param cache where findings are kept; null for nowhere.
 */
internal class ReportTask(
    private val paths: List<Path>,
    private val search: Search,
    private val form: ReportForm,
    private val folder: Path?,
    private val cache: Path?,
) : Task {
    override fun run(console: Console): ExitCode {
        val report = try {
            search.report(RuleSet.DEFAULT, cache)
        } catch (e: SearchException) {
            console.err.println(e.message)
            return ExitCode.USAGE
        }
        val files = logFiles(paths, console.err)
        val pages = folder?.let { Pages(ReportFolder(it, search.virtualTopics), it, console) }
        val result = console.progress("report").use { bar ->
            report.over(files, { done, total -> bar.advanced(done.toLong(), total.toLong()) }) { log, hooks -> pages?.add(log, hooks) }
        }
        console.out.println(textOf(result).trimEnd())
        pages?.finish(result)
        val isIncomplete = pages?.areComplete == false || result.logs.size < paths.size ||
            result.logs.any { it.unreadable != null || it.hookFailures.isNotEmpty() }
        return when {
            result.logs.all { it.unreadable != null } -> ExitCode.NOTHING
            isIncomplete -> ExitCode.SALVAGED
            else -> ExitCode.WHOLE
        }
    }

    private fun textOf(result: ReportResult) = when (form) {
        ReportForm.TEXT -> reportText(result)
        ReportForm.CSV -> reportCsv(result)
        ReportForm.JSON -> reportJson(result)
    }

    /** The pages of the logs, made as soon as each log was looked at. */
    private class Pages(private val report: ReportFolder, private val folder: Path, private val console: Console) {
        private val failures = ArrayList<String>()

        /** Whether every log that can be read has its page. */
        val areComplete: Boolean get() = failures.isEmpty()

        fun add(log: LogReport, hooks: List<HookOutcome>) {
            try {
                report.add(log, hooks)
            } catch (e: ExportException) {
                failures += e.message.orEmpty()
            }
        }

        fun finish(result: ReportResult) {
            try {
                console.err.println("The index is ${report.writeIndex(result)}.")
            } catch (e: IOException) {
                failures += "$folder cannot be written (${e.message}); choose another folder."
            }
            failures.forEach(console.err::println)
        }
    }
}
