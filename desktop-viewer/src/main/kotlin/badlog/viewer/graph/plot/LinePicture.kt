package badlog.viewer.graph.plot

import badlog.plot.curve.Strokes

/**
 * A line of numbers in pixels.
 *
 * @property axis which of the graph's scales it has.
 * @property strokes what is drawn, in pixels from the plot's top left corner.
 */
internal class LinePicture(val line: DrawnLine, val axis: Int, val strokes: Strokes)
