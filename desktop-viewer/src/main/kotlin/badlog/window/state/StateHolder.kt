package badlog.window.state

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue

/**
 * A part of the window: an immutable state, and actions that change it. Composables that draw the state are recomposed when it
 * changes. Use it only on the window's thread.
 */
internal open class StateHolder<S>(initial: S) {
    /** The current state. */
    var state: S by mutableStateOf(initial)
        private set

    /** Replaces the state by the result of [transition]. */
    fun change(transition: S.() -> S) {
        state = state.transition()
    }
}
