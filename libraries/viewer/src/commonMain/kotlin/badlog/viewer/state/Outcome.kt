package badlog.viewer.state

/**
 * The outcome of an action.
 *
 * @property state the state from now on.
 * @property request the task for the shell; null for none.
 */
class Outcome(val state: ViewerState, val request: Request? = null)
