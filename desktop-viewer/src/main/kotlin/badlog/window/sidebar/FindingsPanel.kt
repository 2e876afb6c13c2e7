package badlog.window.sidebar

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import badlog.catalog.folder.LogEntry
import badlog.viewer.choices.board.evidenceOffers
import badlog.viewer.panel.ListedTasks
import badlog.viewer.panel.finding.FindingDetails
import badlog.viewer.panel.finding.FindingsShown
import badlog.viewer.panel.finding.findingsPanel
import badlog.viewer.shown.folder.Changes
import badlog.viewer.state.Action
import badlog.window.findings.CurrentFindings
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.panel.PanelView
import badlog.window.todo.FolderTodo

/**
 * The findings in [open], see [findingsPanel].
 *
 * @param changes the differences between the log and earlier ones.
 * @param isComparing whether other logs are drawn.
 */
@Composable
internal fun FindingsPanel(
    findings: CurrentFindings,
    todo: FolderTodo,
    view: AxisView,
    board: GraphBoard,
    open: OpenRecording,
    changes: Changes<LogEntry>,
    isComparing: Boolean,
    send: (Action) -> Unit,
    modifier: Modifier,
) {
    val known = findings.state
    val names = remember(open) { open.view.recording.topics.filter { it.size > 0 }.map { it.name }.sorted() }
    val evidence = board.evidence
    val details =
        remember(open, evidence) { FindingDetails(evidence.graphs.isNotEmpty(), evidenceOffers(open.view, open.vocabulary, evidence)) }
    val list = todo.state.list.takeIf { todo.state.folder != null }
    val parts = remember(open, known.list, view.findings, view.visited, changes, details, list, isComparing, view.unfolded) {
        val shown = FindingsShown(
            known.list,
            isRunning = known.list == null,
            view.findings,
            view.visited,
            open.times,
            changes.differences,
            names,
            todo = list?.let { ListedTasks(it, open.file.fileName.toString(), todo.author) },
            details = details,
            isComparing = isComparing,
            unfolded = view.unfolded,
        )
        findingsPanel(shown)
    }
    PanelView(parts, listOf(view.visited, view.findings.query), send, modifier)
}
