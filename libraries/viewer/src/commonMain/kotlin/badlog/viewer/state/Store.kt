package badlog.viewer.state

/** The variable for the state, which only a [Store] sets. Everything that a shell draws follows it. */
interface StateCell {
    /** The current state. */
    var state: ViewerState
}

/**
 * Applies actions to the state; a shell cannot change it in any other way.
 *
 * @param cell the variable with the state.
 * @param shown the content of the open log.
 * @param perform performs a task that only the shell can perform.
 */
class Store(private val cell: StateCell, private val shown: Shown, private val perform: (Request) -> Unit) {
    /** The current state. */
    val state: ViewerState get() = cell.state

    /** Lets [action] change the state, then performs its request. */
    fun send(action: Action) {
        var before: ViewerState
        var outcome: Outcome
        do {
            before = cell.state
            outcome = reduce(before, shown, action)
            // Asking the shell for its content may have led to another action.
        } while (cell.state !== before)
        cell.state = outcome.state
        outcome.request?.let(perform)
    }
}

/**
 * The outcome of an action.
 *
 * @property state the state from now on.
 * @property request the task for the shell; null for none.
 */
class Outcome(val state: ViewerState, val request: Request? = null)
