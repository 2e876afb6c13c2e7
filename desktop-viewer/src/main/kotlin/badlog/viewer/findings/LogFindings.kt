package badlog.viewer.findings

import androidx.compose.runtime.snapshotFlow
import badlog.analysis.LogView
import badlog.rules.Finding
import badlog.rules.FolderRules
import badlog.rules.over
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
import badlog.viewer.panels.MainView
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.filterNotNull
import kotlinx.coroutines.runInterruptible
import kotlinx.coroutines.withTimeoutOrNull
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Runs the rules over the open recording in the background, once its graphs are there, and again when it has grown. Opening
 * another recording gives up what runs.
 *
 * @param find finds out what there is in a recording.
 */
internal class RuleRunning(
    private val viewer: Viewer,
    private val find: (view: LogView, file: Path, library: Path?) -> FindingList = ::findingsOf,
) {
    /** Follows the window until cancelled. */
    suspend fun keep() = snapshotFlow { Wanted(viewer.open?.file, viewer.library.folder, viewer.findings.timesAsked) }
        .collectLatest { wanted ->
            viewer.findings = viewer.findings.unknown()
            if (wanted.file == null) return@collectLatest
            awaitGraphs()
            snapshotFlow { viewer.open?.takeIf { it.file == wanted.file }?.logged }.filterNotNull().conflate().collect { view ->
                val began = TimeSource.Monotonic.markNow()
                val list = runInterruptible(Dispatchers.IO) { find(view, wanted.file, wanted.library) }
                viewer.findings = viewer.findings.knowing(list)
                delay(restAfter(began.elapsedNow()))
            }
        }

    private data class Wanted(val file: Path?, val library: Path?, val timesAsked: Int)

    /** Whoever opens a log wants to see it first. */
    private suspend fun awaitGraphs() = withTimeoutOrNull(PATIENCE) {
        while (viewer.panels.main == MainView.GRAPHS && viewer.graphs.graphs.isNotEmpty() && !areDrawn()) delay(POLL)
    }

    private fun areDrawn() = viewer.plots.areReady(viewer.drawnRecordings(), viewer.viewport.visible)

    private companion object {
        val POLL = 50.milliseconds
        val PATIENCE = 3.seconds

        /** Running them over a log that grows must leave the machine to what writes it. */
        fun restAfter(running: Duration): Duration = maxOf(2.seconds, running * 9)
    }
}

/**
 * Runs the rules for [file], which was read as [view], over it. Takes its time; interrupting the thread gives up.
 *
 * @param library the folder of logs, see [FolderRules.of].
 */
internal fun findingsOf(view: LogView, file: Path, library: Path?): FindingList {
    val rules = FolderRules.of(file, library)
    return try {
        val found = rules.rules.over(view, file.fileName.toString()) { if (Thread.interrupted()) throw InterruptedException() }
        FindingList(found.findings, found.skipped, rules.file, rules.problem)
    } catch (_: OutOfMemoryError) {
        FindingList(trouble = "There is not enough memory to run the rules over this log; close other logs and run them again.")
    }
}

/** Takes the cursor and the view to [finding], and shades its time; one of the whole log is only chosen. */
internal fun goTo(viewer: Viewer, finding: Finding) {
    viewer.findings = viewer.findings.copy(chosen = finding)
    if (!finding.time.isFinite()) return
    viewer.cursor = finding.time
    viewer.isCursorPinned = true
    viewer.viewport = viewer.viewport.revealing(finding.time)
}

/** Goes to the finding that is [steps] further on than the one of before, or else than the cursor. */
internal fun stepFinding(viewer: Viewer, steps: Int) {
    // Who has moved the cursor meanwhile goes on from there.
    val from = viewer.findings.chosen?.takeIf { it.time == viewer.cursor }
    viewer.findings.list?.stepped(steps, from, viewer.cursor)?.let { goTo(viewer, it) }
}
