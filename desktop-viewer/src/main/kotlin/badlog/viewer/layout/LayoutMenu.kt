package badlog.viewer.layout

import androidx.compose.runtime.Composable
import androidx.compose.ui.input.key.Key
import badlog.viewer.files.FileChoice
import badlog.viewer.files.askToWrite
import badlog.viewer.files.fileNameOf
import badlog.viewer.files.sayNoLog
import badlog.viewer.keyboard.KeyPress
import badlog.viewer.library.Library
import badlog.viewer.menu.Menu
import badlog.viewer.menu.MenuEntry
import badlog.viewer.recording.CurrentRecording
import badlog.viewer.task.LongTasks
import badlog.viewer.task.Notices
import badlog.viewer.theme.Icons

/** The menu that saves how the window is arranged, and arranges it so again. */
@Composable
internal fun LayoutMenu(current: CurrentRecording, layouts: LayoutStore, files: LayoutFiles) {
    Menu("Layout", "Layout: graphs, ranges and panels", Icons.Layout) {
        val why = "Open a log first.".takeIf { current.recording == null }
        listOf(
            MenuEntry("Default graphs", "As the log's attributes define", why) { layouts.showDefaultGraphs() },
            MenuEntry("Save the layout as…", "A file for another folder, or for a teammate", why, SAVE_LAYOUT.text) { files.save() },
            MenuEntry("Open a layout…", "Topics that this log lacks are hidden", why) { files.open() },
        )
    }
}

internal val SAVE_LAYOUT = KeyPress(Key.S, "S", ctrl = true)

/** Layouts in files that a person names. */
internal class LayoutFiles(
    private val layouts: LayoutStore,
    private val library: Library,
    private val current: CurrentRecording,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) {
    /** Asks for a file, and writes to it how the window is arranged. */
    fun save() {
        val open = current.recording ?: return sayNoLog(notices)
        val folder = library.state.folder
        val name = fileNameOf(folder?.fileName?.toString() ?: "badlog")
        val file = askToWrite(files, notices, "Save the layout", folder ?: open.file.parent, name, Layout.ENDING) ?: return
        val layout = layouts.layout
        tasks.run("Saving the layout", { writeLayout(file, layout) }) { notices.say("Saved the layout to $file.") }
    }

    /** Asks for a layout's file, and arranges the window as it says. */
    fun open() {
        val start = library.state.folder ?: current.recording?.file?.parent
        val file = files.toRead("Open a layout", start, Layout.ENDING) ?: return
        tasks.run("Opening ${file.fileName}", { readLayout(file) }) { layouts.apply(it) }
    }
}
