package badlog.window.layout

import androidx.compose.runtime.snapshotFlow
import badlog.files.writeAtomically
import badlog.viewer.choices.board.FolderLayout
import badlog.viewer.choices.board.keptLayoutAfter
import badlog.viewer.choices.board.layoutMistake
import badlog.viewer.choices.board.noLayoutKept
import badlog.window.folder.Library
import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.task.assertOffWindow
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.runInterruptible
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/**
 * The layouts that are kept in a folder.
 *
 * @property files their files by name, in the order of the names.
 * @property shown the name of the layout that a person requested last; null for none.
 */
internal data class LayoutsOfFolder(val files: Map<String, Path> = emptyMap(), val shown: String? = null)

/**
 * The layouts in the folder of logs, which a key shows in turn. They are files that a person has saved there under names of their own. Use
 * it only on the window's thread.
 */
internal class KeptLayouts(
    private val library: Library,
    private val current: CurrentRecording,
    private val layouts: LayoutStore,
    private val tasks: LongTasks,
    private val notices: Notices,
) : StateHolder<LayoutsOfFolder>(LayoutsOfFolder()) {
    private val folder: Path? get() = library.state.folder ?: current.recording?.file?.parent
    private var opening: Job? = null

    /** Looks for the layouts of each opened folder, until cancelled. */
    suspend fun run() = snapshotFlow { folder }.collectLatest { opened ->
        change { LayoutsOfFolder() }
        if (opened == null) return@collectLatest
        try {
            val found = runInterruptible(Dispatchers.IO) { FolderLayout.keptIn(opened) }
            change { copy(files = found) }
        } catch (_: IOException) {
            // The list of logs reports that the folder cannot be read.
        }
    }

    /** Shows the graphs of the layout [steps] after the shown one; looks for newly saved files. */
    fun step(steps: Int) {
        val folder = folder ?: return
        opening?.cancel()
        // Immediately, since a person may press the key several times.
        keptLayoutAfter(state.files.keys.toList(), state.shown, steps)?.let { next -> change { copy(shown = next) } }
        val wasKnown = state.shown in state.files
        opening = tasks.run("Looking for layouts", { FolderLayout.keptIn(folder) }) { found ->
            if (folder != this.folder) return@run
            change { copy(files = found) }
            val next = if (wasKnown && state.shown in found) state.shown else keptLayoutAfter(found.keys.toList(), null, steps)
            if (next == null) notices.say(noLayoutKept("Ctrl+S saves one beside the logs")) else show(next)
        }
    }

    /** Shows the graphs of the layout called [name], in the visible range. */
    fun show(name: String) {
        val file = state.files[name] ?: return
        // Even if it cannot be read: the key then continues after it.
        change { copy(shown = name) }
        opening?.cancel()
        opening = tasks.run("Opening $name", { readLayout(file) }) { layout ->
            layouts.switchTo(layout)
            notices.say("Layout “$name”.")
        }
    }

    /** Lists the layout that was saved as [file]. It must be beside the logs and have a name of its own. */
    fun add(file: Path) {
        val name = FolderLayout.nameOf(file) ?: return
        if (file.parent == folder) change { LayoutsOfFolder(FolderLayout.inOrder(files + (name to file)), name) }
    }
}

/**
 * Reads the layout in [file]. Call it off the window's thread.
 *
 * @throws IOException with a sentence for the user, if it is missing, damaged, or not a layout.
 */
internal fun readLayout(file: Path): Layout {
    assertOffWindow()
    val name = file.fileName
    val text = try {
        if (Files.size(file) > MAX_BYTES) throw IOException("$name is too large for a layout; select a file that badlog has saved.")
        Files.readString(file)
    } catch (e: CharacterCodingException) {
        throw IOException("$name is not a layout, since it is not text; select a file that badlog has saved.", e)
    } catch (e: NoSuchFileException) {
        throw IOException("$file does not exist; select another layout.", e)
    }
    val layout = try {
        JSON.decodeFromString<Layout>(text)
    } catch (e: IllegalArgumentException) {
        throw IOException(layoutMistake("$name", text), e)
    }
    if (layout.version > Layout.VERSION) throw IOException("$name was saved by a newer badlog; update badlog to open it.")
    return layout
}

/**
 * Writes [layout] to [file] atomically. Call it off the window's thread.
 *
 * @throws IOException with a sentence for the user, if it cannot be written.
 */
internal fun writeLayout(file: Path, layout: Layout) {
    assertOffWindow()
    val text = JSON.encodeToString(Layout.serializer(), layout)
    writeAtomically(file) { it.write(text.encodeToByteArray()) }
}

private const val MAX_BYTES = 16L shl 20

private val JSON = Json {
    ignoreUnknownKeys = true
    prettyPrint = true
    explicitNulls = false
}

/** Returns [file] in the form for a layout: relative to [folder] if it is in it. Its parts are separated by `/` on every system. */
internal fun pathText(file: Path, folder: Path?): String {
    val base = folder?.toAbsolutePath()?.normalize()
    return if (base != null && file.startsWith(base)) base.relativize(file).joinToString("/") else file.toString()
}

/** Returns the file that a layout contains as [text], relative to [folder]; null if [text] is not a valid path. */
internal fun pathOf(text: String, folder: Path?): Path? = try {
    (folder?.toAbsolutePath()?.resolve(text) ?: Path.of(text)).takeIf { it.isAbsolute }?.normalize()
} catch (_: InvalidPathException) {
    null
}
