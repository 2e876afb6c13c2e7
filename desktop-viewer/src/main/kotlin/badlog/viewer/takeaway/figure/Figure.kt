package badlog.viewer.takeaway.figure

import badlog.plot.Span

/**
 * A picture of graphs below one another over the same x, with all that is to be read in it. Holds as many points as its
 * width can show, whatever the recording's length.
 *
 * @property title what stands above it.
 * @property xTitle what stands below it.
 * @property x the part of x that it shows.
 * @property frames its graphs, from top to bottom.
 */
internal class Figure(val title: String, val xTitle: String, val x: Span, val frames: List<FigureFrame>)

/**
 * One frame of a [Figure]: lines over a y axis of one unit, or lanes of states.
 *
 * @property title what stands above it.
 * @property yTitle what stands beside its y axis; empty for nothing.
 * @property y the part of y that it shows.
 * @property isFilled whether the area between its lines and 0 is filled.
 * @property hasLegend whether its title alone does not tell what its lines are.
 * @property lines its lines; empty where it has [lanes].
 * @property lanes its lanes, from top to bottom; empty where it has [lines].
 */
internal class FigureFrame(
    val title: String,
    val yTitle: String,
    val y: Span,
    val isFilled: Boolean,
    val hasLegend: Boolean,
    val lines: List<FigureLine>,
    val lanes: List<FigureLane>,
) {
    /** What its legend says: each line's label, and its colour. */
    val legend: List<Pair<String, String>> get() = lines.map { it.label to it.colour }
}

/**
 * A line of a [FigureFrame].
 *
 * @property label what the legend calls it.
 * @property colour its colour, as `#rrggbb`.
 * @property pieces what is joined by a stroke; between them the line is broken.
 * @property hasDots whether each of its points deserves a dot.
 */
internal class FigureLine(val label: String, val colour: String, val pieces: List<FigurePiece>, val hasDots: Boolean)

/** Points that one stroke joins: `(x[i], y[i])`. */
internal class FigurePiece(val x: List<Double>, val y: List<Double>)

/**
 * A lane of a [FigureFrame].
 *
 * @property label what stands beside it.
 * @property blocks the states it shows, in the order in which they are drawn: the short ones last.
 */
internal class FigureLane(val label: String, val blocks: List<FigureBlock>)

/** A stretch of x, [from] to [to], in the state [name]; [colour] as `#rrggbb`. */
internal class FigureBlock(val from: Double, val to: Double, val name: String, val colour: String)
