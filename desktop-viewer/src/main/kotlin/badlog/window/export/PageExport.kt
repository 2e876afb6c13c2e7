package badlog.window.export

import badlog.catalog.match.MatchMaker
import badlog.core.analysis.LogView
import badlog.core.text.freeName
import badlog.exporter.ExportException
import badlog.exporter.HtmlExporter
import badlog.exporter.layoutFor
import badlog.expression.undefinedTopics
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.readLog
import badlog.formats.LOG_FORMATS
import badlog.protocol.PageAdditions
import badlog.rules.folder.FolderRules
import badlog.signals.namesWith
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.draw.path.FieldFile
import badlog.window.log.OpenRecording
import java.nio.file.Path

/**
 * A page to make.
 *
 * @property log the file to read.
 * @property page the file to write.
 * @property compared the logs that the page compares with its own.
 */
internal data class PageJob(val log: Path, val page: Path, val compared: List<Path> = emptyList())

/**
 * The result of several [PageJob]s.
 *
 * @property made the pages.
 * @property failures a sentence for each log without a page.
 */
internal class ExportedPages(val made: List<Path>, val failures: List<String>)

/** Returns the jobs for the pages of [logs] in [folder], each with a unique name. */
internal fun pageJobs(logs: List<Path>, folder: Path): List<PageJob> {
    val taken = HashSet<String>()
    return logs.distinct().map { log ->
        val name = log.fileName.toString()
        // Most laptops' file systems do not distinguish upper from lower case.
        val page = freeName(name, ".html") { taken.add(it.lowercase()) }
        PageJob(log, folder.resolve(page))
    }
}

/**
 * Makes the pages of [jobs]; a failing one does not affect the others. Interrupting the thread cancels.
 *
 * @param additions the additions to each page.
 * @param progress receives the fraction done, 0 to 1.
 */
internal fun makePages(jobs: List<PageJob>, additions: Additions, progress: (Float) -> Unit = {}): ExportedPages {
    val exporter = HtmlExporter(maker = MatchMaker)
    val made = ArrayList<Path>()
    val failures = ArrayList<String>()
    jobs.forEachIndexed { i, job ->
        if (Thread.interrupted()) throw InterruptedException()
        try {
            val own = if (job.compared.isEmpty()) exporter else HtmlExporter(compared = job.compared, maker = MatchMaker)
            own.export(job.log, job.page, additions.of(job.log)) { done, total ->
                val share = if (total > 0) done.toFloat() / total else 0f
                progress((i + share.coerceAtMost(1f)) / jobs.size)
            }
            made.add(job.page)
        } catch (e: ExportException) {
            failures += e.message ?: "${job.log} could not be exported."
        }
        progress((i + 1f) / jobs.size)
    }
    return ExportedPages(made, failures)
}

/**
 * The additions to pages besides the recordings: working formulas, rules of the folder, field, and initial graphs.
 *
 * @param known recordings that were already read.
 * @param definitions the formulas.
 * @param library the folder of logs, which may have rules.
 * @param field returns the field of each log.
 * @param board the initial graphs; null for the layout of the folder or the log.
 */
internal class Additions(
    known: List<OpenRecording>,
    private val definitions: List<String>,
    private val library: Path?,
    private val board: Board? = null,
    private val field: (Path) -> FieldFile = { FieldFile.of(it, library) },
) {
    private val known = known.associateBy { it.file }

    /** Returns the additions to the page of [log]. */
    fun of(log: Path): PageAdditions {
        val rules = FolderRules.of(log, library)
        val layout = board?.let { BoardLayout(it).toJson() } ?: layoutFor(log, rules.rules.signals, library).text
        return PageAdditions(workingIn(log), rules.rules, rules.problem, layout = layout, field = field(log).json)
    }

    /** Returns the formulas that work in [log]; none if it cannot be read, which the export then reports. */
    private fun workingIn(log: Path): List<String> {
        if (definitions.isEmpty()) return emptyList()
        known[log]?.let { recording -> return recording.formulas.filter { it.topic != null }.map { it.definition } }
        return when (val read = readLog(log, LOG_FORMATS, ReadOptions(keepSamples = false, maker = MatchMaker))) {
            is ReadResult.NotRead -> emptyList()

            is ReadResult.Read -> {
                val names = LogView.of(read.recording).namesWith(FolderRules.of(log, library).rules.signals)
                definitions - undefinedTopics(names, definitions).mapTo(HashSet()) { it.text }
            }
        }
    }
}
