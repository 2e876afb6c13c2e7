package badlog.cli.report

import badlog.cli.command.Outcomes
import badlog.exporter.ExportException
import badlog.report.LogReport
import badlog.report.ReportResult
import badlog.report.hook.HookOutcome
import badlog.report.page.PageCharts
import badlog.report.page.ReportFolder
import kotlinx.serialization.Serializable
import java.nio.file.Path

/**
 * The pages of the logs, each made as soon as its log was examined, and their index.
 *
 * @throws ExportException if the index cannot be written to its place.
 */
internal class ReportPages(private val folder: ReportFolder) {
    private val pages = HashMap<LogReport, Path>()
    private val failures = HashMap<LogReport, String>()

    /** The path of the index, once it is written. */
    var index: Path? = null
        private set

    init {
        folder.checkIndex()
    }

    /** Makes the page of [log]. */
    fun add(log: LogReport, hooks: List<HookOutcome>) {
        try {
            folder.add(log, hooks)?.let { pages[log] = it }
        } catch (e: ExportException) {
            failures[log] = e.message.orEmpty()
        }
    }

    /** Returns the reason why [log] has no page; null if it has one. */
    fun failureOf(log: LogReport): String? = failures[log]

    /** Returns the properties of the page of [log] for programs. */
    fun json(log: LogReport): PageJson = PageJson(pages[log]?.toString(), failures[log])

    /** Writes the index of [result], with the charts from [draw], if at least one log could be read. */
    fun finish(result: ReportResult, outcomes: Outcomes, draw: (List<LogReport>) -> PageCharts) {
        folder.problemsBeside.forEach(outcomes::leaveOut)
        val readable = result.logs.filter { it.unreadable == null }
        if (readable.isEmpty()) return
        val charts = try {
            draw(readable)
        } catch (e: InterruptedException) {
            throw e
        } catch (e: VirtualMachineError) {
            throw e
        } catch (e: Throwable) {
            // This may be an error of loading a class or of finding fonts, too. Without charts, the index of the pages is still useful.
            outcomes.leaveOut("Charts cannot be drawn, so the index has none: ${e.message ?: e.javaClass.simpleName}")
            PageCharts.NONE
        }
        try {
            index = folder.writeIndex(result, charts = charts, leaveOut = outcomes::leaveOut)
        } catch (e: ExportException) {
            outcomes.leaveOut(e.message.orEmpty())
        }
    }
}

/**
 * The options for the pages of a report.
 *
 * @property folder the folder for them and their index.
 * @property isForced whether to replace files there that badlog did not make.
 * @property field the file of the field below the paths; null for the one beside each log.
 * @property hasCharts whether charts of all logs are drawn.
 */
internal class PagesPlan(val folder: Path, val isForced: Boolean, val field: Path?, val hasCharts: Boolean)

/** The place of a log's page, or the reason why there is none. */
@Serializable
internal class PageJson(private val output: String?, private val outputError: String?)
