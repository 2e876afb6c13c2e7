package badlog.window.export

import badlog.files.FolderScan
import badlog.files.reading
import badlog.viewer.catalog.Content
import badlog.viewer.choices.board.Board
import badlog.window.choice.FieldChoice
import badlog.window.compare.ComparedRecordings
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.sayNoLog
import badlog.window.folder.Library
import badlog.window.formula.FormulaStore
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
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
