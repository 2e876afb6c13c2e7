package badlog.window.files

import badlog.files.LogName
import badlog.files.safeName
import badlog.window.task.Notices
import java.awt.FileDialog
import java.awt.Frame
import java.io.FilenameFilter
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import javax.swing.JFileChooser
import javax.swing.UIManager

/** Asks the person for a file or folder. Each answer is null if the person cancels. */
internal interface FileChoice {
    /** Returns a file to write, suggesting [name] in [folder]; overwriting is confirmed. */
    fun toWrite(title: String, folder: Path?, name: String): Path?

    /** Returns a file to read, starting in [folder]. Its name ends in [ending], which is empty for any name. */
    fun toRead(title: String, folder: Path?, ending: String = ""): Path?

    /** Returns a folder, starting in [folder]. */
    fun folder(title: String, folder: Path?): Path?
}

/** Asks with the system's own dialogs. */
internal object SystemFileChoice : FileChoice {
    override fun toWrite(title: String, folder: Path?, name: String): Path? = ask(title, FileDialog.SAVE, folder) { file = name }

    override fun toRead(title: String, folder: Path?, ending: String): Path? = ask(title, FileDialog.LOAD, folder) {
        filenameFilter = FilenameFilter { _, name -> name.endsWith(ending, ignoreCase = true) }
        // Windows ignores the filter, but takes a pattern for the name.
        patternOf(ending, System.getProperty("os.name"))?.let { file = it }
    }

    override fun folder(title: String, folder: Path?): Path? =
        if (isSystem("Mac")) folderOfMac(title, folder) else folderOfSwing(title, folder)

    /** AWT's dialog can select folders only on macOS. */
    private fun folderOfMac(title: String, folder: Path?): Path? {
        System.setProperty(MAC_FOLDERS, "true")
        try {
            return ask(title, FileDialog.LOAD, folder) {}
        } finally {
            System.clearProperty(MAC_FOLDERS)
        }
    }

    private fun folderOfSwing(title: String, folder: Path?): Path? {
        // Only on Windows, the system's look provides the dialog that people know from other programs.
        if (isSystem("Windows")) UIManager.setLookAndFeel(UIManager.getSystemLookAndFeelClassName())
        val chooser = JFileChooser(folder?.toFile())
        chooser.dialogTitle = title
        chooser.fileSelectionMode = JFileChooser.DIRECTORIES_ONLY
        val answer = chooser.showDialog(owner(), "Select")
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

/**
 * Returns the pattern for names that end in [ending] in the dialog of [system]. It is null if the dialog filters names itself, or if
 * [ending] is empty.
 */
internal fun patternOf(ending: String, system: String): String? = "*$ending".takeIf { ending.isNotEmpty() && system.startsWith("Windows") }

/**
 * Asks for a file to write, suggesting [name], and adds a missing [ending]. Returns null if nothing is to be written. An existing file is
 * replaced only if the person typed its full name, because the dialog then asked for confirmation.
 */
internal fun askToWrite(files: FileChoice, notices: Notices, title: String, folder: Path?, name: String, ending: String): Path? {
    val chosen = files.toWrite(title, folder, name + ending) ?: return null
    if (chosen.fileName.toString().endsWith(ending, ignoreCase = true)) return chosen
    val file = chosen.resolveSibling("${chosen.fileName}$ending")
    if (!Files.exists(file)) return file
    notices.complain("${file.fileName} exists already; enter its full name to replace it.")
    return null
}

/** Complains that no log is open. */
internal fun sayNoLog(notices: Notices) = notices.complain("Open a log first.")

/** Returns [text] as the name of a file on any system. It has no forbidden characters, is not the name of a device, and is not too long. */
internal fun fileNameOf(text: String): String = text.map { if (it.isISOControl() || it in FORBIDDEN) '-' else it }
    .joinToString("")
    .trim(' ', '.')
    .take(MAX_LENGTH)
    .ifEmpty { "badlog" }
    .let(::safeName)

/** Returns the name of [file] without the endings of its format. */
internal fun stemOf(file: Path): String = fileNameOf(LogName.of(file.fileName.toString()).stem)

private const val FORBIDDEN = "\\/:*?\"<>|"
private const val MAX_LENGTH = 120

/** Returns the file or folder that prevents files from being written in [folder], which need not exist. Null if none is known. */
internal fun obstacleTo(folder: Path): Path? {
    val nearest = generateSequence(folder.toAbsolutePath()) { it.parent }.firstOrNull { Files.exists(it) }
    return nearest?.takeUnless { Files.isDirectory(it) && (Files.isWritable(it) || takesFile(it)) }
}

/** Returns whether a file can be created in [folder]. On Windows, Java mistakes some folders of a network for read-only ones. */
private fun takesFile(folder: Path): Boolean = try {
    Files.delete(Files.createTempFile(folder, ".badlog-", ".part"))
    true
} catch (_: IOException) {
    false
}
