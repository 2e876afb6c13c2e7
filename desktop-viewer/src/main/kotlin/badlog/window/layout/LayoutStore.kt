package badlog.window.layout

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.FolderLayout
import badlog.viewer.choices.formula.joined
import badlog.viewer.input.KeyAction
import badlog.viewer.session.link.actionsOfKept
import badlog.viewer.session.link.keptText
import badlog.viewer.state.Action
import badlog.viewer.state.BoardAction
import badlog.viewer.state.PlaceAction
import badlog.window.choice.AxisChoice
import badlog.window.compare.ComparedRecordings
import badlog.window.folder.Library
import badlog.window.formula.FormulaStore
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.settings.OwnFiles
import badlog.window.sidebar.WindowPanels
import badlog.window.task.FileWrites
import badlog.window.task.NoticeAction
import badlog.window.task.Notices
import badlog.window.task.assertOffWindow
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.suspendCancellableCoroutine
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.coroutines.resume
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * The window's layout for each folder of logs: saves it, and restores it when the folder is opened. Use it only on the window's
 * thread.
 */
internal class LayoutStore(
    private val own: OwnFiles,
    private val library: Library,
    private val current: CurrentRecording,
    private val board: GraphBoard,
    private val view: AxisView,
    private val compared: ComparedRecordings,
    private val axis: AxisChoice,
    private val formulas: FormulaStore,
    private val panels: WindowPanels,
    private val notices: Notices,
    private val writes: FileWrites,
    private val afterShown: (() -> Unit) -> Unit,
) {
    private val layouts = FolderLayouts(own.folders.settings.resolve("layouts"))

    // The thread on which a log is opened also reads these three.

    /** The folder with the layout that this window has restored, and saves; null for none. */
    var folder: Path? by mutableStateOf(null)
        private set

    @Volatile
    private var saved: Layout? = null

    /** Completed as soon as the layout of the last opened folder is restored. */
    @Volatile
    private var restored: Job = Job().apply { complete() }

    /** The layout of this window as it was last read or written, to find its later changes. */
    private var stored: Layout? = null
    private val graphs = ArrangedGraphs(current, board, notices, ::whenStillOpen) { saved?.graphs?.takeIf { _ -> isInFolder(it.file) } }
    private var restoredChecks: List<Path> = emptyList()
    private var restoredVisible: Span? = null
    private var restoredSelection: Span? = null

    /** Whether a person has checked, zoomed or selected nothing since the log was shown, apart from the restored state. */
    val isUntouched: Boolean
        get() = compared.state.checked.all { it in restoredChecks } &&
            (!view.viewport.isZoomed || view.viewport.visible == restoredVisible) &&
            (view.selection == null || view.selection == restoredSelection)

    /** The current layout of the window. */
    val layout: Layout
        get() {
            val open = current.recording
            // While another folder is being opened, the layout is still the log's.
            val place = folder ?: library.state.folder
            val isDefault = open == null || board.arranged.showsSame(open.standardGraphs)
            return Layout(
                version = Layout.VERSION,
                graphs = if (isDefault) null else board.arranged.renumbered(),
                recording = open?.let { pathText(it.file, place) },
                visible = view.viewport.visible.takeIf { view.viewport.isZoomed }?.let(::layoutSpan),
                selection = view.selection?.let(::layoutSpan),
                place = view.place.keptText,
                compared = layoutOf(compared.state, place),
                panels = layoutOf(panels.state),
                overTime = axis.state,
                formulas = formulas.definitions,
            )
        }

    /** The part of the layout that is shared with others: the graphs and the formulas. */
    val shared: BoardLayout get() = BoardLayout(board.arranged.renumbered(), formulas = formulas.definitions)

    /** Returns the log that was last open in [folder]; null if there was none, or it is gone. */
    suspend fun lastOpenIn(folder: Path): LastOpen? = withContext(Dispatchers.IO) {
        val file = layouts.read(folder)?.recording?.let { pathOf(it, folder) }
        file?.takeIf(Files::isRegularFile)?.let { LastOpen(it, layouts.writtenAt(folder)) }
    }

    /** Remembers the latest arrangement before another log is shown. */
    fun keepArranged() {
        saved = change() ?: stored ?: return
    }

    /** See [ArrangedGraphs.show]. */
    fun showGraphs(recording: OpenRecording, isGrowing: Boolean = false) = graphs.show(recording, isGrowing)

    /** See [ArrangedGraphs.following]. */
    fun following(show: () -> Unit) = graphs.following(show)

    /**
     * Returns the formulas to calculate in the log in [file], which is being opened, see [formulasFor]. It waits for the layout of a folder
     * that is opened at the same time. Call it off the window's thread.
     */
    fun formulasToRead(file: Path, layout: FolderLayout): List<String> {
        assertOffWindow()
        runBlocking { restored.join() }
        return formulasFor(file, layout)
    }

    /**
     * Returns the formulas to calculate in the log in [file]. Can be called on any thread. Formulas of the [layout] beside it are included,
     * unless a person has arranged the graphs of this folder.
     */
    fun formulasFor(file: Path, layout: FolderLayout): List<String> {
        val isArranged = saved?.graphs != null || !isInFolder(file)
        return if (isArranged) formulas.definitions else formulas.with(layout.layout?.formulas.orEmpty())
    }

    /** Applies [layout] to the window, and reports topics that the open recording lacks. Its formulas are added to the existing ones. */
    fun apply(layout: Layout) {
        layout.panels?.let { wanted -> panels.change { panelsOf(wanted, this) } }
        formulas.replaceAll(joined(formulas.definitions, layout.formulas))
        layout.overTime?.let(axis::choose)
        compared.restore(layout.compared, library.state.folder)
        // The range belongs to the axis that was chosen above, and graphs may draw the formulas.
        whenStillOpen { open ->
            graphs.apply(layout.graphs, open)
            if (layout.overTime == null || layout.overTime == open.isOverTime || open.timeColumn == null) applyRange(layout)
        }
    }

    /** Shows the graphs of [layout], and adds its missing formulas; the visible range and everything else stay. */
    fun switchTo(layout: Layout) {
        formulas.replaceAll(formulas.with(layout.formulas))
        whenStillOpen { graphs.apply(layout.graphs, it) }
    }

    /** Calls [action] as soon as all logs are shown as chosen, unless a person has opened another log by then. */
    private fun whenStillOpen(action: (OpenRecording) -> Unit) {
        val file = current.recording?.file ?: return
        afterShown { current.recording?.takeIf { it.file == file }?.let(action) }
    }

    /** Shows the open recording's initial graphs, and all of x; offers to restore the previous graphs. */
    fun showStartBoard() {
        val open = current.recording ?: return
        val before = board.history.now
        board.send(BoardAction.ShowAll(open.standardGraphs))
        view.press(KeyAction.SHOW_ALL)
        val after = board.history.now
        if (before.showsSame(after)) return
        val undo = NoticeAction("Undo") { board.send(BoardAction.Revert(before, after)) }
        notices.say("The default graphs are shown.", undo)
    }

    /** Restores the layout of each opened folder, and saves each change after a moment, until cancelled. */
    suspend fun autosave() = snapshotFlow { library.state.folder }.collectLatest { opened ->
        val restoring = Job()
        restored = restoring
        try {
            enter(opened)
        } finally {
            restoring.complete()
        }
        if (opened == null) return@collectLatest
        var wanted = saved
        var since: TimeSource.Monotonic.ValueTimeMark? = null
        snapshotFlow { arrangement() }.collectLatest {
            suspendCancellableCoroutine { waiting -> afterShown { if (waiting.isActive) waiting.resume(Unit) } }
            wanted = wanted?.takeUnless { restoreRange(it) }
            val first = since ?: TimeSource.Monotonic.markNow().also { since = it }
            // The visible range of a followed log is always changing.
            if (first.elapsedNow() < LONGEST) delay(PAUSE_MILLIS)
            save()
            since = null
        }
    }

    /** Restores the layout of the folder [opened], after saving the layout of the previous one; null for none. */
    private suspend fun enter(opened: Path?) {
        if (folder != opened) save()
        val read = opened?.let { withContext(Dispatchers.IO) { layouts.read(it) } }
        folder = opened
        saved = read
        stored = read
        if (opened == null) return
        val isSeen = current.recording?.let { isInFolder(it.file) } == true
        // A person who has already chosen the axis of a log of the folder keeps it.
        if (!isSeen) axis.change { null }
        read?.overTime?.let(axis::choose)
        formulas.replaceAll(read?.formulas.orEmpty())
        current.recording?.let { formulas.replaceAll(formulasFor(it.file, it.layout)) }
        read?.let(::restore)
        afterShown { if (graphs.enter(openInFolder())) stored = stored?.copy(graphs = null) }
    }

    /** Saves immediately instead of a moment later, because the window is about to close. */
    fun saveNow() = writes.finish {
        try {
            store()
        } catch (_: IOException) {
            // The window that could report it is closing.
        }
    }

    // Everything that affects a layout; the parts themselves are compared, so that checking costs nothing.
    private fun arrangement() = listOf(
        current.recording,
        board.arranged,
        view.viewport.visible,
        view.selection,
        view.place.keptText,
        compared.state,
        panels.state,
        axis.state,
        formulas.definitions,
    )

    /** Saves the changes. */
    suspend fun save() = withContext(NonCancellable) {
        try {
            store()
        } catch (e: IOException) {
            own.cannotSave(e)
        }
    }

    /** Stores the changes. Graphs, formulas and other parts that other windows changed meanwhile stay as they stored them. */
    private suspend fun store() {
        val place = folder ?: return
        val mine = change()
        // Changes that could not be stored may have been undone.
        saved = mine ?: stored
        if (mine == null) return
        val before = stored ?: Layout(Layout.VERSION)
        val initial = openInFolder()?.let(graphs::initial) ?: Board()
        writes.write { layouts.update(place) { theirs -> theirs?.let { merged(mine, before, it, initial) } ?: mine } }
        stored = mine
    }

    /** Returns the layout to save, or null if it is saved already. The state of another folder's recording does not count. */
    private fun change(): Layout? {
        if (folder == null) return null
        val open = openInFolder()
        val changed = if (open == null) {
            (saved ?: Layout(Layout.VERSION)).copy(formulas = formulas.definitions)
        } else {
            // A recording that lacks a signal must not make all others forget it.
            layout.copy(graphs = graphs.toStore(open))
        }
        return changed.takeIf { it != (stored ?: Layout(Layout.VERSION)) }
    }

    private fun restore(layout: Layout) {
        layout.panels?.let { wanted -> panels.change { panelsOf(wanted, this) } }
        if (layout.compared.files.isNotEmpty()) {
            compared.restore(layout.compared, library.state.folder)
            restoredChecks = compared.state.checked
        }
    }

    /** Shows the range of [layout], and selects its selection; if the recording lacks that range, all of it is shown. */
    private fun applyRange(layout: Layout) {
        if (current.recording == null) return
        val full = view.viewport.full
        val visible = layout.visible?.let(::spanOf)?.takeIf { it.from < full.to && it.to > full.from }
        view.send(if (visible == null) Action.Press(KeyAction.SHOW_ALL) else PlaceAction.Show(visible.from, visible.to))
        view.send(PlaceAction.Select(layout.selection?.let(::spanOf)))
        actionsOfKept(layout.place).forEach(view::send)
    }

    /** Shows the last visible range, if the recording is the same as then. Returns whether a recording of the folder is open. */
    private fun restoreRange(layout: Layout): Boolean {
        val open = openInFolder() ?: return false
        if (pathText(open.file, folder) == layout.recording) {
            applyRange(layout)
            restoredVisible = view.viewport.visible
            restoredSelection = view.selection
        }
        return true
    }

    private fun openInFolder() = current.recording?.takeIf { isInFolder(it.file) }

    private fun isInFolder(file: Path) = folder?.let { file.startsWith(it.toAbsolutePath().normalize()) } ?: false

    private companion object {
        const val PAUSE_MILLIS = 600L
        val LONGEST = 3.seconds
    }
}

/** The log in [file], which was last open at [millis] since 1970. */
internal class LastOpen(val file: Path, val millis: Long)
