package badlog.viewer.graph.plot

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.snapshotFlow
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.withContext

/**
 * Keeps the picture of [state] as [request] wants it, null for as it is. It is made off the window's thread; while one is being
 * made, only the latest of further requests is kept.
 */
@Composable
internal fun PictureEffect(state: PlotState, curves: CurveCache, request: () -> PlotRequest?) {
    val latest by rememberUpdatedState(request)
    LaunchedEffect(state, curves) {
        snapshotFlow { latest() }.conflate().collect { wanted ->
            if (wanted != null && wanted != state.picture?.request) {
                val before = state.picture
                // The old picture stands in for the new one only while it is one of the same thing.
                if (before != null && before.request.spec.lines.none { it in wanted.spec.lines }) state.picture = null
                state.picture = withContext(Dispatchers.Default) { makePicture(wanted, curves) }
                // Sixty images a second would fill the memory long before anything else collects them.
                before?.image?.close()
            }
        }
    }
}
