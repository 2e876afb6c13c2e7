package badlog.viewer.graph.plot

import badlog.analysis.Series

/**
 * A line of numbers in pixels.
 *
 * @property series its samples, for the values under the cursor.
 * @property axis which of the graph's scales it has.
 * @property points the ends of its pieces: x and y in turn, one array for each part between gaps.
 * @property dots the samples that deserve a dot, x and y in turn: each of few, and what stands alone between two gaps.
 * @property isDense whether it has more samples than the screen has columns.
 * @property hasDots whether its samples are so far apart that each deserves a dot.
 */
internal class LinePicture(
    val line: DrawnLine,
    val series: Series,
    val axis: Int,
    val points: List<FloatArray>,
    val dots: FloatArray,
    val isDense: Boolean,
    val hasDots: Boolean,
)
