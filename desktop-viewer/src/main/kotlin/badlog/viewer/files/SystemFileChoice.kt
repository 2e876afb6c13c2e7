package badlog.viewer.files

import java.awt.FileDialog
import java.awt.Frame
import java.io.FilenameFilter
import java.nio.file.Path
import javax.swing.JFileChooser
import javax.swing.UIManager

/** Asks by the system's own dialogs. */
internal object SystemFileChoice : FileChoice {
    override fun toWrite(title: String, folder: Path?, name: String): Path? = ask(title, FileDialog.SAVE, folder) { file = name }

    override fun toRead(title: String, folder: Path?, ending: String): Path? = ask(title, FileDialog.LOAD, folder) {
        filenameFilter = FilenameFilter { _, name -> name.endsWith(ending, ignoreCase = true) }
    }

    override fun folder(title: String, folder: Path?): Path? =
        if (isSystem("Mac")) folderOfMac(title, folder) else folderOfSwing(title, folder)

    /** AWT's dialog chooses folders on macOS alone. */
    private fun folderOfMac(title: String, folder: Path?): Path? {
        System.setProperty(MAC_FOLDERS, "true")
        try {
            return ask(title, FileDialog.LOAD, folder) {}
        } finally {
            System.clearProperty(MAC_FOLDERS)
        }
    }

    private fun folderOfSwing(title: String, folder: Path?): Path? {
        // On Windows alone the system's look brings the dialog that people know from elsewhere.
        if (isSystem("Windows")) UIManager.setLookAndFeel(UIManager.getSystemLookAndFeelClassName())
        val chooser = JFileChooser(folder?.toFile())
        chooser.dialogTitle = title
        chooser.fileSelectionMode = JFileChooser.DIRECTORIES_ONLY
        val answer = chooser.showDialog(owner(), "Choose")
        return if (answer == JFileChooser.APPROVE_OPTION) chooser.selectedFile?.toPath() else null
    }

    private fun ask(title: String, mode: Int, folder: Path?, prepare: FileDialog.() -> Unit): Path? {
        val dialog = FileDialog(owner(), title, mode)
        dialog.directory = folder?.toString()
        dialog.prepare()
        dialog.isVisible = true
        val name = dialog.file ?: return null
        return Path.of(dialog.directory.orEmpty(), name).toAbsolutePath().normalize()
    }

    private fun owner(): Frame? = Frame.getFrames().firstOrNull { it.isActive }

    private fun isSystem(name: String) = System.getProperty("os.name").startsWith(name)

    private const val MAC_FOLDERS = "apple.awt.fileDialogForDirectories"
}
