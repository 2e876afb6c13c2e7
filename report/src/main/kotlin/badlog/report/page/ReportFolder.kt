package badlog.report.page

import badlog.html.ExportException
import badlog.html.HtmlExporter
import badlog.report.LogReport
import badlog.report.ReportResult
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.util.UUID

/**
 * A folder with a report: `index.html`, and a page for each log.
 *
 * @param exporter makes the pages of the logs; null for the index alone.
 */
public class ReportFolder(private val folder: Path, private val exporter: HtmlExporter? = HtmlExporter()) {
    /**
     * What was written.
     *
     * @property index the index.
     * @property failures why some logs have no page.
     */
    public class Written internal constructor(public val index: Path, public val failures: List<ExportException>)

    /**
     * Writes the report. Pages that were there are replaced, others stay.
     *
     * @param progress hears how many pages are written.
     * @throws IOException when the folder or the index cannot be written.
     * @throws InterruptedException when the thread was interrupted.
     */
    public fun write(
        result: ReportResult,
        title: String = "Report",
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
    ): Written {
        Files.createDirectories(folder)
        val pages = HashMap<LogReport, String>()
        val failures = ArrayList<ExportException>()
        if (exporter != null) {
            val logs = result.logs.filter { it.unreadable == null }
            val names = pageNames(logs)
            logs.forEachIndexed { index, log ->
                try {
                    exporter.export(log.file.path, folder.resolve(names.getValue(log)))
                    pages[log] = names.getValue(log)
                } catch (e: ExportException) {
                    failures += e
                }
                progress(index + 1, logs.size)
            }
        }
        val index = folder.resolve(INDEX)
        val draft = folder.resolve(".badlog-${UUID.randomUUID()}.part")
        try {
            Files.writeString(draft, reportPage(result, title) { pages[it] })
            Files.move(draft, index, StandardCopyOption.REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(draft)
        }
        return Written(index, failures)
    }

    private fun pageNames(logs: List<LogReport>): Map<LogReport, String> {
        val taken = hashSetOf(INDEX)
        return logs.associateWith { log ->
            val base = log.file.name.replace(ENDINGS, "")
            generateSequence(1) { it + 1 }.map { if (it == 1) "$base.html" else "$base ($it).html" }.first { taken.add(it.lowercase()) }
        }
    }

    private companion object {
        const val INDEX = "index.html"
        val ENDINGS = Regex("(\\.(bag|badbag|csv|wpilog))?(\\.gz)?$", RegexOption.IGNORE_CASE)
    }
}
