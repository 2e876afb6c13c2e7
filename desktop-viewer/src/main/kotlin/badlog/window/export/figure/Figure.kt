package badlog.window.export.figure

import badlog.core.analysis.Span
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.figure.FigureNotes

/**
 * A picture of graphs below one another over the same x, with everything that can be read in it. It has as many points
 * as its width can show, however long the recording is.
 *
 * @property title its heading.
 * @property xTitle the text below it.
 * @property x the part of x that it shows.
 * @property frames its graphs, from top to bottom.
 * @property marks the marks in every frame.
 * @property notes the text below it; null for nothing.
 */
internal class Figure(
    val title: String,
    val xTitle: String,
    val x: Span,
    val frames: List<FigureFrame>,
    val marks: FigureMarks = FigureMarks(),
    val notes: FigureNotes? = null,
)

/**
 * One frame of a [Figure]: lines over a y axis of one unit, or lanes of states.
 *
 * @property title its heading.
 * @property yTitle the text beside its y axis; empty for nothing.
 * @property y the part of y that it shows.
 * @property isFilled whether the area between its lines and 0 is filled.
 * @property hasLegend whether its lines need more than its title.
 * @property lines its lines; empty if it has [lanes].
 * @property lanes its lanes, from top to bottom; empty if it has [lines].
 * @property plane what it shows if its lines are not over the figure's x; otherwise null.
 */
internal class FigureFrame(
    val title: String,
    val yTitle: String,
    val y: Span,
    val isFilled: Boolean,
    val hasLegend: Boolean,
    val lines: List<FigureLine>,
    val lanes: List<FigureLane>,
    val plane: FigurePlane? = null,
) {
    /** What its legend says: each line's label, and its color. */
    val legend: List<Pair<String, String>> get() = lines.map { it.label to it.color }
}

/**
 * A line of a [FigureFrame].
 *
 * @property label its name in the legend.
 * @property color its color, as `#rrggbb`.
 * @property strokes its points, x and y as logged, but with x moved by the recording's offset.
 * @property isDashed whether it is planned, rather than driven.
 */
internal class FigureLine(val label: String, val color: String, val strokes: Strokes, val isDashed: Boolean = false)

/**
 * A lane of a [FigureFrame].
 *
 * @property label the text beside it.
 * @property blocks the states it shows, in drawing order: the short ones last.
 */
internal class FigureLane(val label: String, val blocks: List<FigureBlock>)

/** A stretch of x, [from] to [to], in the state [name]; [color] as `#rrggbb`. */
internal class FigureBlock(val from: Double, val to: Double, val name: String, val color: String)

/**
 * What a person may select for a figure.
 *
 * @property width its width, in points of SVG.
 * @property graphHeight the height of one graph's frame, in points of SVG; lanes take what they need.
 * @property format the kind of file.
 */
internal data class FigureOptions(val width: Int = 900, val graphHeight: Int = 150, val format: FigureFormat = FigureFormat.PNG)

/**
 * The kinds of file that a figure can be.
 *
 * @property ending the ending of such files' names.
 * @property meaning what it is good for.
 */
internal enum class FigureFormat(val ending: String, val meaning: String) {
    PNG("png", "for slides, documents and chats"),
    SVG("svg", "sharp at any size, and can be edited"),
}

/** How many pixels a picture has for each point: sharp in print, and on screens of a high density. */
internal const val PICTURE_SCALE = 2
