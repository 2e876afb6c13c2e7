package badlog.viewer.export.pages

import badlog.file.FolderScan
import badlog.file.reading
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.export.openAction
import badlog.viewer.files.askToWrite
import badlog.viewer.files.sayNoLog
import badlog.viewer.library.index.Content
import java.nio.file.Path

/** Asks for a file, and makes the page of the open recording. */
internal fun savePage(viewer: Viewer) {
    val log = viewer.open?.file ?: return sayNoLog(viewer)
    val page = askToWrite(viewer, "Export the page", log.parent, log.fileName.toString(), ".html") ?: return
    makePages(viewer, "Making ${page.fileName}") { listOf(PageJob(log, page)) }
}

/** Asks for a folder, and makes the pages of all ticked recordings. */
internal fun savePagesOfTicked(viewer: Viewer) {
    val logs = viewer.comparison.ticked
    if (logs.isEmpty()) return
    val folder = viewer.files.folder("Export ${logs.size} pages into", viewer.library.folder ?: logs.first().parent) ?: return
    makePages(viewer, "Making pages") { pageJobs(logs, folder) }
}

/** Asks for a folder, and makes the pages of every log in the library's folder, those of its sub-folders included. */
internal fun savePagesOfFolder(viewer: Viewer) {
    val library = viewer.library.folder ?: return
    val folder = viewer.files.folder("Export the pages of all logs into", library) ?: return
    val others = viewer.library.entries.filter { it.content == Content.NO_LOG }.mapTo(HashSet()) { it.file }
    makePages(viewer, "Making the pages of all logs") { pageJobs(logsIn(library).filter { it !in others }, folder) }
}

private fun makePages(viewer: Viewer, title: String, jobs: () -> List<PageJob>) {
    val known = viewer.drawnRecordings().map { it.recording }
    val additions = Additions(known, viewer.formulas, viewer.library.folder)
    viewer.tasks.run(title, { progress -> makePages(jobs(), additions, progress) }) { tell(viewer, it) }
}

private fun tell(viewer: Viewer, pages: PagesMade) {
    val made = pages.made
    when {
        made.size == 1 -> viewer.notices.say("Made ${made.single()}.", openAction(viewer, made.single()))

        made.isNotEmpty() -> {
            val folder = made.first().parent
            viewer.notices.say("Made ${made.size} pages in $folder.", openAction(viewer, folder))
        }

        pages.failures.isEmpty() -> viewer.notices.complain("There is no log in the folder of which to make a page.")
    }
    if (pages.failures.isEmpty()) return
    val more = pages.failures.size - 1
    val others = if (more == 0) "" else " $more more could not be made into pages either."
    viewer.notices.complain(pages.failures.first() + others)
}

/** What may be logs in [folder] and the folders in it, in the order of their paths. */
internal fun logsIn(folder: Path): List<Path> = reading(folder) { FolderScan.of(folder) }.files.map { it.path }.sorted()
