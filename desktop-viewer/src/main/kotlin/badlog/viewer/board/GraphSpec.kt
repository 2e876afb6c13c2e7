package badlog.viewer.board

import badlog.analysis.Span

/**
 * What one graph shows, by names only: the same graph fits every recording of a robot, and a layout keeps it.
 *
 * @property id tells it from the other graphs of the window; has no other meaning.
 * @property title what stands above it.
 * @property lines its lines; a name that a recording lacks is left out there.
 * @property isFilled whether the area below the lines is filled.
 * @property includesZero whether y must include 0.
 * @property yRange the part of y that a person has chosen, or null for as much as the visible samples need.
 */
internal data class GraphSpec(
    val id: Int,
    val title: String,
    val lines: List<LineSpec>,
    val isFilled: Boolean = false,
    val includesZero: Boolean = false,
    val yRange: Span? = null,
)

/**
 * One line of a graph.
 *
 * @property signal the name of the signal it draws.
 */
internal data class LineSpec(val signal: String)
