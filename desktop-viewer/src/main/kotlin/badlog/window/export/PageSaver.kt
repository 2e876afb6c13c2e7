package badlog.window.export

import badlog.catalog.match.MatchMaker
import badlog.core.analysis.LogView
import badlog.core.text.freeName
import badlog.exporter.ExportException
import badlog.exporter.HtmlExporter
import badlog.exporter.layoutFor
import badlog.expression.undefinedTopics
import badlog.files.FolderScan
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.readLog
import badlog.files.reading
import badlog.formats.LOG_FORMATS
import badlog.protocol.PageAdditions
import badlog.rules.folder.FolderRules
import badlog.signals.namesWith
import badlog.viewer.catalog.Content
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.draw.path.FieldFile
import badlog.window.choice.FieldChoice
import badlog.window.compare.ComparedRecordings
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.sayNoLog
import badlog.window.folder.Library
import badlog.window.formula.FormulaStore
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.task.openAction
import kotlinx.coroutines.CoroutineScope
import java.nio.file.Path

/** Saves the page of one log in a file, or the pages of several logs in a folder, that the person selects. */
internal class PageSaver(
    private val scope: CoroutineScope,
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val board: GraphBoard,
    private val formulas: FormulaStore,
    private val fields: FieldChoice,
    private val library: Library,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) {
    /** Asks for a file, and makes the page of the current recording, with the window's graphs and compared logs. */
    fun savePage() {
        val log = current.recording?.file ?: return sayNoLog(notices)
        val page = askToWrite(files, notices, "Export the page", log.parent, log.fileName.toString(), ".html") ?: return
        val others = compared.state.checked.filter { it != log }
        save("Saving ${page.fileName}", board.state) { listOf(PageJob(log, page, others)) }
    }

    /** Asks for a folder, and makes the pages of all checked recordings, with the window's graphs. */
    fun savePagesOfChecked() {
        val logs = compared.state.checked
        if (logs.isEmpty()) return
        val folder = files.folder("Export ${logs.size} pages into", library.state.folder ?: logs.first().parent) ?: return
        save("Saving pages", board.state) { pageJobs(logs, folder) }
    }

    /** Asks for a folder, and makes the page of every log in the library's folder and its subfolders. */
    fun savePagesOfFolder() {
        val top = library.state.folder ?: return
        val folder = files.folder("Export the pages of all logs into", top) ?: return
        val others = library.state.entries.filter { it.summary.content == Content.NO_LOG }.mapTo(HashSet()) { it.file }
        save("Saving the pages of all logs") { pageJobs(logsIn(top).filter { it !in others }, folder) }
    }

    private fun save(title: String, board: Board = Board(), jobs: () -> List<PageJob>) {
        val known = compared.drawn.map { it.recording }
        val additions = Additions(known, formulas.definitions, library.state.folder, board.takeIf { it.graphs.isNotEmpty() }, fields::of)
        tasks.run(title, { progress -> makePages(jobs(), additions, progress) }, ::report)
    }

    private fun report(pages: ExportedPages) {
        val made = pages.made
        when {
            made.size == 1 -> notices.say("Saved ${made.single()}.", openAction(made.single(), scope, notices))

            made.isNotEmpty() -> {
                val folder = made.first().parent
                notices.say("Saved ${made.size} pages in $folder.", openAction(folder, scope, notices))
            }

            pages.failures.isEmpty() -> notices.complain("No logs found in the folder; open one that has some.")
        }
        if (pages.failures.isEmpty()) return
        val more = pages.failures.size - 1
        val others = if (more == 0) "" else " $more more could not be exported either."
        notices.complain(pages.failures.first() + others)
    }
}

/** Returns the files in [folder] and its subfolders that may be logs, sorted by path. */
internal fun logsIn(folder: Path): List<Path> = reading(folder) { FolderScan.of(folder) }.files.map { it.path }.sorted()

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
