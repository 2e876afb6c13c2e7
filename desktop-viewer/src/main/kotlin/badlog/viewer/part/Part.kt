package badlog.viewer.part

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/**
 * A part of the window: an immutable state, and what changes it. Whoever draws the state is drawn again when it changes. To be used
 * on the window's thread only.
 */
internal open class Part<S>(initial: S) {
    /** How things stand. */
    var state: S by mutableStateOf(initial)
        private set

    /** Replaces the state by what [transition] makes of it. */
    fun change(transition: S.() -> S) {
        state = state.transition()
    }
}
