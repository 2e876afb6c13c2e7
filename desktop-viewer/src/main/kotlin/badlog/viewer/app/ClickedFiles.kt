package badlog.viewer.app

import java.awt.Desktop

/** On a Mac, a file that is double-clicked comes as a message to the program that runs already. */
internal fun opensClickedFiles(viewer: Viewer) {
    if (!Desktop.isDesktopSupported()) return
    val desktop = Desktop.getDesktop()
    if (!desktop.isSupported(Desktop.Action.APP_OPEN_FILE)) return
    desktop.setOpenFileHandler { event -> event.files.firstOrNull()?.let { viewer.loading.open(it.toPath()) } }
}
