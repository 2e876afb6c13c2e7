package badlog.window.graph.plot

import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.snapshotFlow
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.withContext

/**
 * Keeps the picture of [state] up to date with [request]; a null request leaves it unchanged. Pictures are made off the window's thread; of
 * the requests in the meantime, only the latest is kept.
 */
@Composable
internal fun PictureEffect(state: PlotState, curves: CurveCache, request: () -> PlotRequest?) {
    val latest by rememberUpdatedState(request)
    LaunchedEffect(state, curves) {
        snapshotFlow { latest() }.conflate().collect { wanted ->
            if (wanted != null && wanted != state.picture?.request) {
                val before = state.picture
                // The old picture stays until then only if it shows one of the same lines.
                if (before != null && before.request.spec.lines.none { it in wanted.spec.lines }) state.picture = null
                state.picture = withContext(Dispatchers.Default) { makePicture(wanted, curves) }
                // Images of sixty frames per second would fill the memory long before the garbage collector frees them.
                before?.image?.close()
            }
        }
    }
}
