package badlog.viewer.state

/**
 * What an action leads to.
 *
 * @property state the state from now on.
 * @property request what the shell has to do besides; null for nothing.
 */
class Outcome(val state: ViewerState, val request: Request? = null)
