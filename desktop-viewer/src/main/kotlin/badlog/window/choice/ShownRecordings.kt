package badlog.window.choice

import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.snapshots.Snapshot
import badlog.window.compare.ComparedRecordings
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingChoices
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * Keeps what is shown of the open recording and of the compared ones as a person has chosen it: makes it anew off the window's thread
 * after each change of a choice, and shows it when it is made. Use it only on the window's thread.
 *
 * @param library returns the folder of logs.
 * @param choices returns what is chosen for a recording.
 */
internal class ShownRecordings(
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val board: GraphBoard,
    private val view: AxisView,
    private val notices: Notices,
    private val library: () -> Path?,
    private val choices: (OpenRecording) -> RecordingChoices,
) {
    /** Whether something is shown as it was before the last choice. */
    val isWaiting: Boolean get() = wanted().any { (recording, wanted) -> recording.choices != wanted }

    /** Follows the choices, until cancelled. */
    suspend fun run() = snapshotFlow { wanted() }.collectLatest { all ->
        try {
            for ((recording, wanted) in all) {
                if (recording.choices == wanted) continue
                val folder = library()
                show(withContext(Dispatchers.Default) { recording.with(wanted, folder) })
            }
        } catch (_: OutOfMemoryError) {
            notices.complain("There is not enough memory to show that; remove a formula, or compare fewer logs.")
        }
    }

    private fun wanted(): List<Pair<OpenRecording, RecordingChoices>> {
        val all = listOfNotNull(current.recording) + compared.state.loaded.values
        return all.distinctBy { it.file }.map { it to choices(it) }
    }

    private fun show(made: OpenRecording) = Snapshot.withMutableSnapshot {
        compared.share(made)
        val before = current.recording?.takeIf { it.file == made.file } ?: return@withMutableSnapshot
        current.replace(made)
        if (made.choices.overTime != before.choices.overTime) view.show(made.span) else view.change { grown(made.span) }
        made.field.problem?.takeIf { made.field !== before.field }?.let(notices::complain)
        // The time has a graph only if it is not the axis, and the Driver Station's topics have some.
        if (board.kept.showsSame(before.standardGraphs) && !made.standardGraphs.showsSame(before.standardGraphs)) {
            board.replace(made.standardGraphs)
        }
    }
}
