package badlog.viewer.findings

import androidx.compose.runtime.snapshotFlow
import badlog.analysis.LogView
import badlog.viewer.app.MainView
import badlog.viewer.app.Viewer
import badlog.viewer.compare.drawnRecordings
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
