package badlog.viewer.layout

import badlog.viewer.app.Viewer
import badlog.viewer.files.askToWrite
import badlog.viewer.files.fileNameOf
import badlog.viewer.files.sayNoLog

/** Asks for a file, and writes to it how the window is arranged. */
internal fun saveLayout(viewer: Viewer) {
    val open = viewer.open ?: return sayNoLog(viewer)
    val name = fileNameOf(viewer.library.folder?.fileName?.toString() ?: "badlog")
    val start = viewer.library.folder ?: open.file.parent
    val file = askToWrite(viewer, "Save the layout", start, name, Layout.ENDING) ?: return
    val layout = layoutOf(viewer)
    viewer.tasks.run("Saving the layout", { writeLayout(file, layout) }) { viewer.notices.say("Saved the layout to $file.") }
}

/** Asks for a layout's file, and arranges the window as it says. */
internal fun openLayout(viewer: Viewer) {
    val start = viewer.library.folder ?: viewer.open?.file?.parent
    val file = viewer.files.toRead("Open a layout", start, Layout.ENDING) ?: return
    viewer.tasks.run("Opening ${file.fileName}", { readLayout(file) }) { applyLayout(viewer, it) }
}
