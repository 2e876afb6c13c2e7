package badlog.window.layout

import androidx.compose.runtime.Composable
import androidx.compose.ui.input.key.Key
import badlog.core.recording.PathName
import badlog.files.writeAtomically
import badlog.viewer.choices.board.FolderLayout
import badlog.viewer.input.KeyAction
import badlog.window.choice.AxisChoice
import badlog.window.choice.StationChoice
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.files.fileNameOf
import badlog.window.files.sayNoLog
import badlog.window.folder.Library
import badlog.window.log.CurrentRecording
import badlog.window.menu.KeyPress
import badlog.window.menu.Menu
import badlog.window.menu.MenuEntry
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.theme.Icons
import java.nio.file.Path

/** The menu for saving and opening layouts of the window. */
@Composable
internal fun LayoutMenu(
    current: CurrentRecording,
    layouts: LayoutStore,
    kept: KeptLayouts,
    files: LayoutFiles,
    axis: AxisChoice,
    stations: StationChoice,
) {
    Menu("Layout", "Layout: graphs, ranges and panels", Icons.Layout) {
        val why = "Open a log first.".takeIf { current.recording == null }
        val ofFolder = kept.state.files.keys.take(MAX_LISTED).map { name ->
            MenuEntry(name, "A layout in the folder; ${KeyAction.NEXT_LAYOUT.shortcut} shows the next one", why) { kept.show(name) }
        }
        ofFolder + listOfNotNull(
            MenuEntry("Start board", "The default graphs of this log", why) { layouts.showStartBoard() },
            MenuEntry("Save the layout as…", "Beside the logs; G steps through these layouts", why, SAVE_LAYOUT.text) { files.save() },
            MenuEntry("Save as the folder’s default…", "${FolderLayout.NAME}: windows and pages open with it", why) {
                files.saveDefault()
            },
            MenuEntry("Open a layout…", "Topics that this log lacks are hidden", why) { files.open() },
            current.recording?.timeColumn?.let { column ->
                val isOver = axis.state == true
                val name = if (isOver) "row numbers" else "“${PathName.baseNameOf(column.name)}”"
                MenuEntry("Draw over $name", "For all logs of the folder that name no x axis") { axis.choose(!isOver) }
            },
            stations.found?.let { found ->
                val verb = if (stations.isShown) "Hide" else "Show"
                MenuEntry("$verb the Driver Station log", "${found.log.name}, of the same match") { stations.choose(!stations.isShown) }
            },
        )
    }
}

/** The largest number of layouts that fit in the menu; the key goes through all of them. */
private const val MAX_LISTED = 12

internal val SAVE_LAYOUT = KeyPress(Key.S, "S", ctrl = true)

/** Saves and opens layouts in files that a person names. */
internal class LayoutFiles(
    private val layouts: LayoutStore,
    private val kept: KeptLayouts,
    private val library: Library,
    private val current: CurrentRecording,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) {
    /** Asks for a file, and writes the window's layout to it. */
    fun save() {
        val open = current.recording ?: return sayNoLog(notices)
        val folder = library.state.folder
        val name = fileNameOf(folder?.fileName?.toString() ?: "badlog")
        val file = askToWrite(files, notices, "Save the layout", folder ?: open.file.parent, name, Layout.ENDING) ?: return
        val layout = layouts.layout
        tasks.run("Saving the layout", { writeLayout(file, layout) }) {
            kept.add(file)
            notices.say("Saved the layout to $file.")
        }
    }

    /**
     * Asks for a file in the folder of logs, and writes its default layout to it. Windows and pages begin with the graphs and formulas of
     * that layout.
     */
    fun saveDefault() {
        val open = current.recording ?: return sayNoLog(notices)
        val name = FolderLayout.NAME.removeSuffix(Layout.ENDING)
        val folder = library.state.folder ?: open.file.parent
        val file = askToWrite(files, notices, "Save the folder’s default layout", folder, name, Layout.ENDING) ?: return
        val text = layouts.shared.toJson()
        tasks.run("Saving the layout", { writeAtomically(file) { it.write(text.encodeToByteArray()) } }) {
            notices.say("Saved the layout to $file. Windows without an arrangement of their own, and pages made from now on, open with it.")
        }
    }

    /** Asks for a layout file, and applies it to the window. */
    fun open() {
        val start = library.state.folder ?: current.recording?.file?.parent
        open(files.toRead("Open a layout", start, Layout.ENDING) ?: return)
    }

    /** Applies the layout in [file] to the window. */
    fun open(file: Path) {
        tasks.run("Opening ${file.fileName}", { readLayout(file) }) { layouts.apply(it) }
    }
}
