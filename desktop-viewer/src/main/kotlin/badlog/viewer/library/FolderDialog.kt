package badlog.viewer.library

import badlog.viewer.app.Viewer
import java.awt.FileDialog
import java.awt.Frame
import java.nio.file.Path
import javax.swing.JFileChooser
import javax.swing.UIManager

/** Asks for a folder and opens it. */
internal fun chooseFolder(viewer: Viewer) {
    val folder = if (isSystem("Mac")) chosenByMac(viewer.library.folder) else chosenBySwing(viewer.library.folder)
    if (folder != null) viewer.libraryFolder.open(folder)
}

/** Asks for a log and opens it, and its folder where there is none yet. */
internal fun chooseFile(viewer: Viewer) {
    val dialog = FileDialog(owner(), "Open a log", FileDialog.LOAD)
    dialog.directory = viewer.library.folder?.toString()
    dialog.isVisible = true
    val file = dialog.files.firstOrNull()?.toPath() ?: return
    viewer.openNamed(listOf(file))
}

/** The system's own dialog chooses folders on macOS alone. */
private fun chosenByMac(current: Path?): Path? {
    System.setProperty(MAC_FOLDERS, "true")
    try {
        val dialog = FileDialog(owner(), TITLE, FileDialog.LOAD)
        dialog.directory = current?.toString()
        dialog.isVisible = true
        return dialog.files.firstOrNull()?.toPath()
    } finally {
        System.clearProperty(MAC_FOLDERS)
    }
}

private fun chosenBySwing(current: Path?): Path? {
    // On Windows alone the system's look brings the dialog that people know from elsewhere.
    if (isSystem("Windows")) UIManager.setLookAndFeel(UIManager.getSystemLookAndFeelClassName())
    val chooser = JFileChooser(current?.toFile())
    chooser.dialogTitle = TITLE
    chooser.fileSelectionMode = JFileChooser.DIRECTORIES_ONLY
    val answer = chooser.showDialog(owner(), "Open")
    return if (answer == JFileChooser.APPROVE_OPTION) chooser.selectedFile?.toPath() else null
}

private fun owner(): Frame? = Frame.getFrames().firstOrNull { it.isActive }

private fun isSystem(name: String) = System.getProperty("os.name").startsWith(name)

private const val TITLE = "Open a folder of logs"
private const val MAC_FOLDERS = "apple.awt.fileDialogForDirectories"
