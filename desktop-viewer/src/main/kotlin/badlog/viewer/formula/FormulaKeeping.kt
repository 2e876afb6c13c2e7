package badlog.viewer.formula

import androidx.compose.runtime.snapshotFlow
import badlog.viewer.app.Viewer
import badlog.viewer.recording.OpenRecording
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withContext

/** Calculates the formulas anew in the recordings that are shown, whenever a person has changed them. */
internal class FormulaKeeping(private val viewer: Viewer) {
    /** Follows the window until cancelled. */
    suspend fun keep() = snapshotFlow { Shown(viewer.formulas, viewer.open, viewer.comparison.loaded.values.toList()) }
        .collectLatest { (definitions, open, compared) ->
            try {
                if (open != null && open.definitions != definitions) {
                    val changed = calculated(open, definitions)
                    viewer.open = changed
                    viewer.comparisonLoading.share(changed)
                }
                for (other in compared) {
                    if (other.file == open?.file || other.definitions == definitions) continue
                    viewer.comparison = viewer.comparison.withLoaded(calculated(other, definitions))
                }
            } catch (_: OutOfMemoryError) {
                viewer.notices.complain("There is not enough memory for the formulas; remove one, or compare fewer logs.")
            }
        }

    private data class Shown(val definitions: List<String>, val open: OpenRecording?, val compared: List<OpenRecording>)

    private suspend fun calculated(recording: OpenRecording, definitions: List<String>) =
        withContext(Dispatchers.Default) { recording.withFormulas(definitions) }
}
