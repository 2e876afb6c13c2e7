package badlog.viewer.draw.path

import badlog.core.analysis.Span
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.figure.LegendEntry
import badlog.viewer.draw.pen.PenImage
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit

/**
 * The content of a graph of y over x. It has the paths of all drawn logs on one field, otherwise their topics over each other.
 *
 * @param lines the names of the graph's lines.
 * @param origin the origin of the poses.
 * @param logs the drawn logs. The first one is open: the visible range and the cursors are on its x.
 */
class XyPicture(lines: List<String>, origin: FieldOrigin, logs: List<XyLog>) {
    private val axis = logs.firstOrNull()?.paths?.view?.xAxis

    /**
     * The parts of the logs that have any of the lines. Only logs of the same kind as the first one are shown: with paths, or without.
     */
    val parts: List<XyPart> = logs.mapIndexedNotNull { i, log -> log.paths.plotOf(lines, origin)?.let { XyPart(log, it, i, logs.size) } }
        .let { all -> all.filter { it.plot.isField == all[0].plot.isField } }

    /** The strokes of the trace that is being drawn. They are reused: allocating arrays for a million places in each frame takes long. */
    private val strokes = Strokes()

    /** Whether there is nothing to draw. */
    val isEmpty: Boolean get() = parts.isEmpty()

    /** Whether the picture shows a field. */
    val isField: Boolean get() = !isEmpty && parts[0].plot.isField

    /** The whole extent of all logs; null if there is nothing to draw. */
    val full: Plane? by lazy {
        val planes = parts.map { it.plot.full }
        if (planes.isEmpty()) null else Plane(spanOf(planes.map { it.x }), spanOf(planes.map { it.y }))
    }

    /**
     * Returns the plane to show in a frame of [width] by [height] pixels. It is [selected], or [full] if that is null or cannot be drawn.
     * Null if there is nothing to draw. A field keeps its shape.
     */
    fun seen(selected: Plane?, width: Double, height: Double): Plane? {
        val wanted = selected?.takeIf { it.isDrawable && !isEmpty } ?: full
        return if (isField) wanted?.fitted(width, height) else wanted
    }

    /**
     * Draws the part of the picture in [visible] into [frame]. On a field, it also draws the rest faintly.
     *
     * @param hidden the names of the lines that are not drawn.
     * @param ground the picture of the field; null if there is none.
     * @param axesFrom the room for the axes to the left of the frame; null if they are not drawn with it.
     */
    fun draw(frame: XyFrame, hidden: Set<String>, visible: Span, ground: PenImage?, axesFrom: Double? = null) {
        if (isEmpty) return
        XyDrawing(frame, parts[0].plot).ground(ground)
        if (axesFrom != null) drawAxes(frame, axesFrom)
        for (part in parts) part.drawTraces(frame, hidden, visible, strokes)
        for (part in parts) {
            part.drawNotes(frame, visible) { time -> axis?.let { withUnit(placeText(time, it, visible.width), it.unit) }.orEmpty() }
        }
    }

    /** Draws the numbers and the titles of both axes around [frame], with [left] pixels to its left. */
    fun drawAxes(frame: XyFrame, left: Double) {
        if (!isEmpty) XyDrawing(frame, parts[0].plot).axes(left)
    }

    /** Draws everything that is not [hidden] at its place at [cursors]; at the second one, dots are rings. */
    fun drawCursors(frame: XyFrame, hidden: Set<String>, cursors: Cursors) {
        for (part in parts) part.drawCursors(frame, hidden, cursors)
    }

    /** Returns a figure's legend for everything that is not [hidden], with its places at [cursors]. */
    fun legend(hidden: Set<String>, cursors: Cursors): List<LegendEntry> = parts.flatMap { it.entries }.filter { it.isShown(hidden) }
        .map { LegendEntry("${it.title} ${it.textAt(cursors)}".trim(), it.color) }

    /**
     * Returns the time when the first log passed nearest to ([x], [y]), at most [reach] pixels away, within [visible]. The result is null
     * if it never did. If it passed more than once, the result is the time nearest to [before].
     *
     * @param pixelX the length of a pixel along x, and [pixelY] along y: distances are measured on the screen.
     */
    fun timeAt(x: Double, y: Double, pixelX: Double, pixelY: Double, reach: Double, visible: Span, before: Double?): Double? {
        val part = parts.firstOrNull() ?: return null
        val offset = part.log.offset
        val time = part.plot.timeAt(x, y, pixelX, pixelY, reach, part.own(visible), before?.minus(offset))
        return if (time.isNaN()) null else time + offset
    }

    private fun spanOf(spans: List<Span>) = Span(spans.minOf { it.from }, spans.maxOf { it.to })
}
