package badlog.window.graph.plot

import badlog.viewer.draw.plot.Plot
import org.jetbrains.skia.Image

/**
 * A graph that is ready to be drawn: everything is in pixels, and nothing is left to calculate.
 *
 * @property request the request it was made for.
 * @property plot the plot for a pen.
 * @property lines the lines of numbers, in the same order as in [plot].
 * @property lanes the lanes of states, below the lines.
 * @property image the drawn lines; null if there are none.
 */
internal class PlotPicture(
    val request: PlotRequest,
    val plot: Plot,
    val lines: List<DrawnLine>,
    val lanes: List<DrawnLine>,
    val image: Image?,
) {
    /** The height of the lines, in pixels; the lanes have the rest. */
    val plotHeight: Float get() = (request.height * (1 - plot.laneShare)).toFloat()

    /** Returns whether it shows [line]. */
    operator fun contains(line: DrawnLine): Boolean = line in lines || line in lanes
}

/** Returns the text beside the lane of [line], which is one of [all]: its title, the name of its recording, or both. */
internal fun laneName(line: DrawnLine, all: List<DrawnLine>): String {
    val label = line.label?.take(MAX_LETTERS) ?: return line.title.take(MAX_LETTERS)
    return if (all.all { it.signal.name == line.signal.name }) label else "${line.title.take(MAX_LETTERS)} · $label"
}

private const val MAX_LETTERS = 40
