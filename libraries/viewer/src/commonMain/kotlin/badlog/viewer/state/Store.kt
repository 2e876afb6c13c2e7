package badlog.viewer.state

/** A variable for the state, which only a [Store] sets: whatever a shell draws follows it. */
interface StateCell {
    /** The current state. */
    var state: ViewerState
}

/**
 * Lets actions change the state, the only way from a shell to it.
 *
 * @param cell where the state is.
 * @param shown the content of the open log.
 * @param perform does what only the shell can do.
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
