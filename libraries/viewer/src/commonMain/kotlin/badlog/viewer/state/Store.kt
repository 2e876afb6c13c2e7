package badlog.viewer.state

/** Where a shell keeps the state: a variable that whatever it draws follows. */
interface StateCell {
    /** The current state. */
    var state: ViewerState
}

/**
 * Lets actions change the state, the only way from a shell to it.
 *
 * @param cell where the state is.
 * @param shown what is known of the open log.
 * @param perform does what only the shell can do.
 */
class Store(private val cell: StateCell, private val shown: Shown, private val perform: (Request) -> Unit) {
    /** Lets [action] change the state, and then does what it asks of the shell. */
    fun send(action: Action) {
        val outcome = reduce(cell.state, shown, action)
        cell.state = outcome.state
        outcome.request?.let(perform)
    }
}
