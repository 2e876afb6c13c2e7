package badlog.viewer.takeaway

import java.awt.FileDialog
import java.awt.Frame
import java.io.FilenameFilter
import java.nio.file.Path
import javax.swing.JFileChooser

/** Asks by the system's own dialogs. */
internal object SystemFileChoice : FileChoice {
    override fun toWrite(title: String, folder: Path?, name: String): Path? = ask(title, FileDialog.SAVE, folder) { file = name }

    override fun toRead(title: String, folder: Path?, ending: String): Path? = ask(title, FileDialog.LOAD, folder) {
        filenameFilter = FilenameFilter { _, name -> name.endsWith(ending, ignoreCase = true) }
    }

    // AWT's dialog chooses files only.
    override fun folder(title: String, folder: Path?): Path? {
        val chooser = JFileChooser(folder?.toFile())
        chooser.dialogTitle = title
        chooser.fileSelectionMode = JFileChooser.DIRECTORIES_ONLY
        val answer = chooser.showDialog(Frame.getFrames().firstOrNull { it.isActive }, "Choose")
        return if (answer == JFileChooser.APPROVE_OPTION) chooser.selectedFile.toPath() else null
    }

    private fun ask(title: String, mode: Int, folder: Path?, prepare: FileDialog.() -> Unit): Path? {
        val dialog = FileDialog(Frame.getFrames().firstOrNull { it.isActive }, title, mode)
        dialog.directory = folder?.toString()
        dialog.prepare()
        dialog.isVisible = true
        val name = dialog.file ?: return null
        return Path.of(dialog.directory.orEmpty(), name).toAbsolutePath().normalize()
    }
}
