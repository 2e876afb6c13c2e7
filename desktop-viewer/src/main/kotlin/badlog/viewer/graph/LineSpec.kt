package badlog.viewer.graph

/**
 * One line of a graph.
 *
 * @property signal the name of the signal it draws.
 */
internal data class LineSpec(val signal: String)
