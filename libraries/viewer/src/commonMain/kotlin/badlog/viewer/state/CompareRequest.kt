package badlog.viewer.state

import badlog.viewer.choices.comparison.Alignment

/** A task that concerns the logs compared with the open one; each has its index among them. */
sealed interface CompareRequest : Request {
    /** Lets the person choose a log to compare. */
    object Choose : CompareRequest

    /** Stops comparing. */
    object Clear : CompareRequest

    /** Aligns all logs by [alignment]. */
    class Align(val alignment: Alignment) : CompareRequest

    /** Moves [log] to [offset], in units of x. */
    data class Move(val log: Int, val offset: Double) : CompareRequest

    /** Stops comparing with [log]. */
    data class Remove(val log: Int) : CompareRequest
}
