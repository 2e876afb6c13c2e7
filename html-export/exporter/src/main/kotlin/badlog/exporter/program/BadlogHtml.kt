package badlog.exporter.program

import badlog.core.recording.Severity
import badlog.exporter.EmptyPage
import badlog.exporter.ExportException
import badlog.exporter.ExportReport
import badlog.exporter.HtmlExporter
import badlog.exporter.PageNetwork
import badlog.exporter.checkReadable
import badlog.exporter.fieldFor
import badlog.exporter.layoutFor
import badlog.exporter.videoFor
import badlog.files.NO_LOGS_SENTENCE
import badlog.files.ReadResult
import badlog.files.terminal.Progress
import badlog.files.terminal.ProgressBar
import badlog.files.terminal.printable
import badlog.protocol.PageAdditions
import badlog.rules.RuleSet
import badlog.rules.folder.FolderRules
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path

/** Makes the page of an input, like [HtmlExporter.export]. */
internal typealias Export = (input: Path, page: Path, additions: PageAdditions, progress: Progress) -> ExportReport

/**
 * The command line: makes the requested pages, prints their paths, and reports problems.
 *
 * @param out receives one line for each page: its absolute path.
 * @param err receives all other messages.
 * @param isTerminal whether [err] is a terminal, which can show a progress bar.
 * @param exporterOf returns the exporting function for the given attachments and logs to compare; each page contains the attachments.
 * @param open opens a page in the browser; returns false if that failed.
 */
internal class BadlogHtml(
    private val out: PrintStream,
    private val err: PrintStream,
    private val isTerminal: Boolean,
    private val exporterOf: (attachments: List<Path>, compared: List<Path>) -> Export = { attachments, compared ->
        val exporter = HtmlExporter(attachments, compared)
        val export: Export = exporter::export
        export
    },
    private val open: (Path) -> Boolean,
) {
    private val made = ArrayList<ExportReport>()
    private var failed = 0
    private var skipped = 0
    private val rulesOfFolder = HashMap<Path, FolderRules>()
    private val problemsBeside = HashSet<String>()

    /** Runs the program with [arguments]. Call it once. */
    fun run(arguments: List<String>): ExitCode = when (val parsed = ArgumentParser().parse(arguments)) {
        is ArgumentParser.Result.Run -> export(parsed.arguments)
        is ArgumentParser.Result.Say -> ExitCode.WHOLE.also { out.println(parsed.text) }
        is ArgumentParser.Result.Refuse -> ExitCode.USAGE.also { err.println(parsed.text) }
    }

    private fun export(arguments: Arguments): ExitCode {
        arguments.field?.let { fieldFor(it, it).problem }?.let {
            err.println(printable(it))
            return ExitCode.USAGE
        }
        val jobs = try {
            (arguments.attachments + arguments.compared + listOfNotNull(arguments.video)).forEach(::checkReadable)
            ExportPlan(arguments).jobs()
        } catch (e: ExportException) {
            err.println(e.message)
            return ExitCode.NOTHING
        }
        if (arguments.video != null && jobs.size > 1) {
            err.println("--video shows one match; name only its log.")
            return ExitCode.USAGE
        }
        for ((name, network) in arguments.emptyPages) if (!makeEmpty(arguments.emptyPage(name), network)) return ExitCode.NOTHING
        if (arguments.paths.isEmpty()) return ExitCode.WHOLE
        val export = exporterOf(arguments.attachments, arguments.compared)
        jobs.forEachIndexed { index, job ->
            val label = (if (jobs.size > 1) "${index + 1}/${jobs.size} " else "") + job.input.fileName
            make(job, { additions(job, arguments) }, export, ProgressBar(label, err, isTerminal))
        }
        sayWhatIsMissing()
        if (arguments.opensPage) openNewest(jobs)
        return when {
            made.isEmpty() -> ExitCode.NOTHING

            failed > 0 || rulesOfFolder.values.any { it.problem != null } || problemsBeside.isNotEmpty() ||
                made.any { it.recording.isSalvaged } -> ExitCode.SALVAGED

            else -> ExitCode.WHOLE
        }
    }

    private fun makeEmpty(page: Path, network: PageNetwork): Boolean = try {
        EmptyPage().write(page, network)
        out.println(page)
        true
    } catch (e: ExportException) {
        err.println(e.message)
        false
    }

    private fun additions(job: ExportJob, arguments: Arguments): PageAdditions {
        val rules = rulesOfFolder.getOrPut(job.input.toAbsolutePath().normalize().parent) {
            FolderRules.of(job.input).also { rules -> rules.problem?.lines()?.forEach { err.println(printable(it)) } }
        }
        val layout = layoutFor(job.input, rules.rules.signals)
        val field = fieldFor(job.input, arguments.field)
        for (problem in listOfNotNull(layout.problem, field.problem)) if (problemsBeside.add(problem)) err.println(printable(problem))
        return PageAdditions(
            // A page without rules must still know when the robot was enabled.
            rules = if (arguments.hasRules) rules.rules else RuleSet.NONE.with(rules.rules.signals),
            rulesProblem = rules.problem.takeIf { arguments.hasRules },
            layout = layout.text,
            field = field.json,
            video = arguments.video?.let { videoFor(job.page, it) },
        )
    }

    private fun make(job: ExportJob, additions: () -> PageAdditions, export: Export, bar: ProgressBar) {
        try {
            val report = bar.use { export(job.input, job.page, additions(), it) }
            made += report
            out.println(report.page)
            saySalvaged(job, report)
        } catch (e: ExportException) {
            if (e is ExportException.NotARecording && job.isFound) {
                skipped++
            } else {
                fail(e.message)
            }
        } catch (e: Throwable) {
            // Whatever the failure is, the other files should still get their pages.
            fail(ReadResult.NotRead.of(job.input, e).sentence)
        }
    }

    private fun fail(message: String?) {
        failed++
        err.println(message)
    }

    private fun saySalvaged(job: ExportJob, report: ExportReport) {
        val losses = report.recording.problems.filter { it.severity == Severity.ERROR }
        val first = losses.firstOrNull() ?: return
        val line = first.line?.let { " (line $it)" }.orEmpty()
        val others = if (losses.size > 1) " The page lists ${losses.size - 1} more." else ""
        err.println("${job.input}: salvaged. ${first.message}$line$others")
    }

    private fun sayWhatIsMissing() {
        if (skipped == 1) err.println("1 file is not a log and was skipped.")
        if (skipped > 1) err.println("$skipped files are not logs and were skipped.")
        if (made.isEmpty() && failed == 0) {
            err.println(NO_LOGS_SENTENCE)
        }
    }

    private fun openNewest(jobs: List<ExportJob>) {
        val pages = made.mapTo(HashSet()) { it.page }
        val newest = jobs.filter { it.page.toAbsolutePath().normalize() in pages }
            .maxByOrNull { Files.getLastModifiedTime(it.input) } ?: return
        if (!open(newest.page)) err.println("No browser could be started; open ${newest.page} yourself.")
    }
}
