package badlog.report.page

import badlog.html.ExportException
import badlog.html.HtmlExporter
import badlog.report.LogReport
import badlog.report.ReportResult
import badlog.report.hook.HookOutcome
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.util.UUID

/**
 * A folder with a report: `index.html`, and a page for each log that was added. Pages that were there are replaced, others stay.
 *
 * @param virtualTopics definitions of topics that the pages show beside the logs' own.
 * @param exporter makes the pages of the logs.
 */
public class ReportFolder(
    private val folder: Path,
    private val virtualTopics: List<String> = emptyList(),
    private val exporter: HtmlExporter = HtmlExporter(),
) {
    private val pages = HashMap<LogReport, String>()
    private val taken = hashSetOf(INDEX)

    /**
     * Makes the page of [log], unless it cannot be read, with its findings and what [hooks] came to.
     *
     * @throws ExportException when the page cannot be made; the others can.
     * @throws InterruptedException when the thread was interrupted.
     */
    public fun add(log: LogReport, hooks: List<HookOutcome> = emptyList()) {
        if (log.unreadable != null) return
        val name = freeName(log)
        exporter.export(log.file.path, folder.resolve(name), pageAdditions(virtualTopics, log.findings, hooks))
        pages[log] = name
    }

    /**
     * Writes the index of [result].
     *
     * @return where it is.
     * @throws IOException when it cannot be written.
     */
    public fun writeIndex(result: ReportResult, title: String = "Report"): Path {
        Files.createDirectories(folder)
        val index = folder.resolve(INDEX)
        val draft = folder.resolve(".badlog-${UUID.randomUUID()}.part")
        try {
            Files.writeString(draft, reportPage(result, title) { pages[it] })
            Files.move(draft, index, StandardCopyOption.REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(draft)
        }
        return index
    }

    private fun freeName(log: LogReport): String {
        val base = log.file.name.replace(ENDINGS, "")
        return generateSequence(1) { it + 1 }
            .map { if (it == 1) "$base.html" else "$base ($it).html" }
            .first { taken.add(it.lowercase()) }
    }

    private companion object {
        const val INDEX = "index.html"
        val ENDINGS = Regex("(\\.(bag|badbag|csv|wpilog))?(\\.gz)?$", RegexOption.IGNORE_CASE)
    }
}
