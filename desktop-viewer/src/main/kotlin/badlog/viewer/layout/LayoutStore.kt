package badlog.viewer.layout

import androidx.compose.runtime.snapshotFlow
import badlog.analysis.Span
import badlog.viewer.app.Viewer
import badlog.viewer.formula.takeFormulas
import badlog.viewer.graph.GraphList
import badlog.viewer.graph.standardGraphs
import badlog.viewer.recording.OpenRecording
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Path

/**
 * Remembers how the window was arranged over each folder of logs, and arranges it so again when the folder is opened. To be
 * used on the window's thread only.
 */
internal class LayoutKeeping(private val viewer: Viewer) {
    private val layouts = FolderLayouts(viewer.folders.settings.resolve("layouts"))
    private var folder: Path? = null
    private var remembered: Layout? = null
    private var restoredTicks: List<Path> = emptyList()
    private var restoredVisible: Span? = null
    private var restoredSelection: Span? = null

    /** Whether nobody has ticked, zoomed or marked anything since the log was shown: what was restored here, nobody did now. */
    val isUntouched: Boolean
        get() = viewer.comparison.ticked.all { it in restoredTicks } &&
            (!viewer.viewport.isZoomed || viewer.viewport.visible == restoredVisible) &&
            (viewer.selection == null || viewer.selection == restoredSelection)

    /** The graphs to show of [recording], which was just opened: as they were arranged over this folder, else the standard ones. */
    fun graphsOf(recording: OpenRecording): GraphList {
        val fitted = fittedTo(recording) ?: return standardGraphs(recording.logged)
        fitted.sentence?.let(viewer.notices::say)
        return fitted.graphs
    }

    /** Follows the window until cancelled. */
    suspend fun keep() = snapshotFlow { viewer.library.folder }.collectLatest { opened ->
        folder = opened
        // A few kilobytes of the user's own: read at once, so that the folder's first recording is shown as it was arranged.
        remembered = opened?.let(layouts::read)
        if (opened == null) return@collectLatest
        takeFormulas(viewer, remembered?.formulas.orEmpty())
        var wanted = remembered
        wanted?.let(::restore)
        snapshotFlow { parts() }.collectLatest {
            wanted = wanted?.takeUnless { restorePlace(it) }
            delay(PAUSE_MILLIS)
            keepChange()
        }
    }

    /** Writes at once what else would be written in a moment: the window is about to go. */
    fun keepNow() {
        val (place, layout) = change() ?: return
        try {
            layouts.write(place, layout)
        } catch (_: IOException) {
            // There is no window any more to say it in.
        }
    }

    // All that changes a layout; compared by the parts themselves, so that to look costs nothing.
    private fun parts() = with(viewer) { listOf(open, graphs, viewport.visible, selection, comparison, panels, formulas) }

    private suspend fun keepChange() {
        val (place, layout) = change() ?: return
        remembered = layout
        try {
            withContext(Dispatchers.IO) { layouts.write(place, layout) }
        } catch (e: IOException) {
            viewer.notices.complain("The layout cannot be remembered: ${e.message}")
        }
    }

    /** Where to keep what, when that is not yet remembered. What another folder's recording shows is not this folder's. */
    private fun change(): Pair<Path, Layout>? {
        val place = folder ?: return null
        val open = viewer.open?.takeIf(::isInFolder)
        if (open == null) {
            val before = remembered ?: Layout(Layout.VERSION)
            return if (before.formulas == viewer.formulas) null else place to before.copy(formulas = viewer.formulas)
        }
        val shown = layoutOf(viewer)
        // A recording that lacks a signal must not make all others forget it.
        val isAsRemembered = hasSameGraphs(viewer.graphs, fittedTo(open)?.graphs ?: standardGraphs(open.logged))
        val layout = if (isAsRemembered) shown.copy(graphs = remembered?.graphs) else shown
        return if (layout == remembered) null else place to layout
    }

    private fun restore(layout: Layout) {
        layout.panels?.let { viewer.panels = panelsOf(it, viewer.panels) }
        if (layout.compared.files.isNotEmpty()) {
            restoreComparison(viewer, layout.compared)
            restoredTicks = viewer.comparison.ticked
        }
        val open = viewer.open?.takeIf(::isInFolder) ?: return
        if (hasSameGraphs(viewer.graphs, standardGraphs(open.logged))) viewer.graphs = graphsOf(open)
    }

    /** Shows what was last seen, when the recording is the one of then. Returns whether one was opened at all. */
    private fun restorePlace(layout: Layout): Boolean {
        val open = viewer.open?.takeIf(::isInFolder) ?: return false
        if (pathText(open.file, folder) == layout.recording) {
            applyPlace(viewer, layout)
            restoredVisible = viewer.viewport.visible
            restoredSelection = viewer.selection
        }
        return true
    }

    private fun fittedTo(recording: OpenRecording): FittedGraphs? =
        remembered?.graphs?.takeIf { isInFolder(recording) }?.let { fitted(it, recording) }?.takeIf { it.graphs.graphs.isNotEmpty() }

    private fun isInFolder(recording: OpenRecording) = folder?.let { recording.file.startsWith(it.toAbsolutePath().normalize()) } ?: false

    private companion object {
        const val PAUSE_MILLIS = 600L
    }
}
