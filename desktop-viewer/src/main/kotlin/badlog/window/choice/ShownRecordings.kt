package badlog.window.choice

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.snapshots.Snapshot
import badlog.viewer.state.PlaceAction
import badlog.window.compare.ComparedRecordings
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingChoices
import badlog.window.task.Notices
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.currentCoroutineContext
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.isActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.supervisorScope
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * Recalculates the open and the compared recordings after each change of a choice, and then shows them. Each log is calculated separately,
 * off the window's thread. Use it only on the window's thread.
 *
 * @param following calls the given function, which replaces the open recording, and then arranges its graphs again.
 * @param library returns the folder of logs.
 * @param choices returns the choices for a recording.
 */
internal class ShownRecordings(
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val board: GraphBoard,
    private val view: AxisView,
    private val notices: Notices,
    private val following: (() -> Unit) -> Unit,
    private val library: () -> Path?,
    private val choices: (OpenRecording) -> RecordingChoices,
) {
    /** A recording and the choices for it: it is not calculated again while both stay the same. */
    private data class CalculationInput(val recording: OpenRecording, val choices: RecordingChoices)

    private val jobs = HashMap<Path, Pair<CalculationInput, Job>>()
    private val later = ArrayList<() -> Unit>()

    /** The calculations that failed, and are not tried again. */
    private var failed by mutableStateOf(emptyList<CalculationInput>())

    /** Whether a shown recording does not reflect the last choice yet. */
    val isWaiting: Boolean get() = wanted().any(::needsCalculation)

    /** Follows the choices, until cancelled. */
    suspend fun run() = supervisorScope { snapshotFlow { wanted() }.collect { follow(it) } }

    private fun CoroutineScope.follow(all: List<CalculationInput>) {
        for (file in jobs.keys - all.mapTo(HashSet()) { it.recording.file }) jobs.remove(file)?.second?.cancel()
        for (each in all) {
            val file = each.recording.file
            if (jobs[file]?.first == each) continue
            jobs.remove(file)?.second?.cancel()
            if (needsCalculation(each)) jobs[file] = each to launch { calculate(each, this@follow) }
        }
        catchUp()
    }

    /** Calls [action] as soon as all recordings are shown as chosen; immediately if they are. */
    fun afterShown(action: () -> Unit) {
        later += action
        catchUp()
    }

    /** Shows [made], which was read or calculated to replace the shown recording of the same file. */
    fun show(made: OpenRecording) = Snapshot.withMutableSnapshot { following { showNow(made) } }

    private fun showNow(made: OpenRecording) {
        compared.share(made)
        val before = current.recording?.takeIf { it.file == made.file } ?: return
        // Standard graphs change with the axis and with the Driver Station's topics. The time has a graph only if it is not the axis.
        val isOtherAxis = made.isOverTime != before.isOverTime
        val isDefault = (if (isOtherAxis) board.arranged else board.history.now).showsSame(before.standardGraphs)
        current.replace(made)
        view.send(PlaceAction.Grow(made.span, isOtherAxis))
        made.field.problem?.takeIf { it != before.field.problem }?.let(notices::complain)
        if (isDefault && !made.standardGraphs.showsSame(before.standardGraphs)) board.replace(made.standardGraphs)
    }

    private suspend fun calculate(wanted: CalculationInput, scope: CoroutineScope) {
        try {
            val folder = library()
            val made = withContext(Dispatchers.Default) { wanted.recording.with(wanted.choices, folder) { ensureActive() } }
            jobs.remove(wanted.recording.file)
            // The recording may have grown or been closed just before this.
            if (wanted in wanted()) show(made)
        } catch (e: CancellationException) {
            throw e
        } catch (_: OutOfMemoryError) {
            failed = failed + wanted
            notices.complain("There is not enough memory to show that; remove a formula, or compare fewer logs.")
        } catch (e: Throwable) {
            failed = failed + wanted
            throw e
        } finally {
            if (currentCoroutineContext().isActive) scope.follow(wanted())
        }
    }

    private fun catchUp() {
        if (isWaiting) return
        failed = failed.filter { it in wanted() }
        val due = later.toList()
        later.clear()
        due.forEach { it() }
    }

    private fun needsCalculation(wanted: CalculationInput) = wanted.recording.choices != wanted.choices && wanted !in failed

    private fun wanted(): List<CalculationInput> {
        val all = listOfNotNull(current.recording) + compared.state.loaded.values
        return all.distinctBy { it.file }.map { CalculationInput(it, choices(it)) }
    }
}
