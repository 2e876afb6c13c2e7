package badlog.cli.report

import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.Task
import badlog.cli.input.logFiles
import badlog.report.Report
import badlog.report.ReportResult
import badlog.report.page.ReportFolder
import badlog.report.reportCsv
import badlog.report.reportJson
import badlog.report.reportText
import badlog.report.rules.RuleSet
import badlog.report.rules.RulesException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Runs rules over every log below [paths].
 *
 * @param rules the file of rules, or null for those that badlog brings along.
 * @param folder where pages and their index go; null for none.
 * @param cache where findings are kept; null for nowhere.
 */
internal class ReportTask(
    private val paths: List<Path>,
    private val rules: Path?,
    private val form: ReportForm,
    private val folder: Path?,
    private val cache: Path?,
) : Task {
    override fun run(console: Console): ExitCode {
        val ruleSet = try {
            rules?.let { RuleSet.parse(Files.readString(it)) } ?: RuleSet.DEFAULT
        } catch (e: RulesException) {
            console.err.println("$rules: ${e.message}")
            return ExitCode.USAGE
        } catch (_: IOException) {
            console.err.println("The rules in $rules cannot be read; look for a typing error in its name.")
            return ExitCode.USAGE
        }
        val files = logFiles(paths, console.err)
        val result = console.progress("report").use { bar ->
            Report(ruleSet, cache).over(files, { done, total -> bar.advanced(done.toLong(), total.toLong()) })
        }
        console.out.println(textOf(result).trimEnd())
        val hasPages = folder == null || writePages(result, folder, console)
        return when {
            result.logs.all { it.unreadable != null } -> ExitCode.NOTHING
            !hasPages || result.logs.size < paths.size || result.logs.any { it.unreadable != null } -> ExitCode.SALVAGED
            else -> ExitCode.WHOLE
        }
    }

    private fun textOf(result: ReportResult) = when (form) {
        ReportForm.TEXT -> reportText(result)
        ReportForm.CSV -> reportCsv(result)
        ReportForm.JSON -> reportJson(result)
    }

    private fun writePages(result: ReportResult, folder: Path, console: Console): Boolean = try {
        val written = console.progress("pages").use { bar ->
            ReportFolder(folder).write(result) { done, total -> bar.advanced(done.toLong(), total.toLong()) }
        }
        for (failure in written.failures) console.err.println(failure.message)
        console.err.println("The index is ${written.index}.")
        written.failures.isEmpty()
    } catch (e: IOException) {
        console.err.println("$folder cannot be written (${e.message}); choose another folder.")
        false
    }
}
