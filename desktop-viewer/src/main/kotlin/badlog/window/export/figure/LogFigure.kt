package badlog.window.export.figure

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.titleOf
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.figure.FigureNotes
import badlog.viewer.draw.figure.LegendEntry
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.figure
import badlog.viewer.draw.figure.graphHead
import badlog.viewer.draw.figure.xTitle
import badlog.viewer.draw.lane.LaneLook
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.path.XyFrame
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.PlotMarks
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.draw.plot.drawSamples
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.text.unitText
import badlog.window.compare.DrawnRecording
import badlog.window.graph.plot.CurveCache
import badlog.window.graph.plot.DrawnLine
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotRequest
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.plot.makePicture
import badlog.window.graph.xy.groundOf
import badlog.window.graph.xy.xyPictureOf
import badlog.window.theme.Palette

/**
 * A picture of graphs below one another over the same range of [x]. It shows everything that can be read in them. The first of [recordings]
 * is the open one; each is moved by its offset. The picture has as many points as its width can show, however long the recordings are.
 *
 * @property width its width in points.
 * @param graphHeight the height of a graph's lines in points.
 * @param events the events of the open recording to mark.
 * @param findings its findings, if known.
 * @param notes the x of each note.
 * @param board all graphs of the screen: some may share y limits with graphs in the figure.
 * @param cursors the cursors on the open recording's x, where values are read for the legends.
 */
internal class LogFigure(
    private val recordings: List<DrawnRecording>,
    private val x: Span,
    val width: Int = FigureOptions().width,
    private val graphHeight: Int = FigureOptions().graphHeight,
    private val events: EventTimeline = EventTimeline.NONE,
    private val findings: FindingTimeline<Finding>? = null,
    private val notes: List<Double> = emptyList(),
    private val board: List<BoardGraph> = emptyList(),
    private val cursors: Cursors = Cursors(),
) {
    private val open = recordings.first().recording
    private val colors = PenColors.LIGHT
    private val curves = CurveCache()

    /** Returns the [graphs] that have a visible line in any of the recordings. */
    fun drawable(graphs: List<BoardGraph>): List<BoardGraph> = graphs.filter { graph ->
        if (graph.isXy) !xyPictureOf(graph, recordings).isEmpty else drawnLines(graph, recordings).any { it.signal.name !in graph.hidden }
    }

    /** Draws [graphs] on [sheet]. Reads samples: call it off the window's thread. Interrupting its thread stops it. */
    fun draw(sheet: Sheet, graphs: List<BoardGraph>) {
        val title = recordings.joinToString(" · ") { it.name }
        val texts = FigureNotes.of("${open.file.fileName}", open.view.xAxis, x, cursors, open.clocks, findings)
        sheet.figure(title, texts, drawable(graphs).map { graph -> { if (graph.isXy) drawXy(it, graph) else drawGraph(it, graph) } })
    }

    private fun drawGraph(sheet: Sheet, graph: BoardGraph) {
        if (Thread.interrupted()) throw InterruptedException()
        val shown = drawnLines(graph, recordings).filter { it.signal.name !in graph.hidden }
        val lanes = shown.count { it.signal.states != null }
        val height = PlotMargins.HEIGHT + lanes * LaneLook.HEIGHT + if (lanes < shown.size) graphHeight else 0
        val density = sheet.pen.density
        val frame = PlotMargins.frameOf(sheet.width, height, x, density)
        val picture = pictureOf(graph, frame, density)
        sheet.graphHead(Board(board).titleOf(graph), unit = "", legendOf(graph, shown))
        sheet.part(height.toDouble()) { pen ->
            val marks = PlotMarks(open.modes, events, findings, notes)
            pen.drawPlot(frame, picture.plot, marks, colors, PlotMargins.BOTTOM * density)
            pen.drawCursors(frame, cursors, colors)
            cursors.x?.let { pen.drawSamples(frame, picture.plot, picture.lines, it, colors) }
        }
        sheet.xTitle(open.view.xAxis.title)
    }

    /** Returns the picture of [graph] in [frame], with places measured from the edge of the sheet. */
    private fun pictureOf(graph: BoardGraph, frame: PlotFrame, density: Double): PlotPicture {
        val sharing = if (graph.sharesY) board.filter { it.sharesY && it.id != graph.id && !it.isXy } else emptyList()
        val (width, height) = frame.width.toInt() to frame.height.toInt()
        val request = PlotRequest(graph, recordings, x, width, height, Palette.LIGHT, density.toFloat(), sharing)
        val picture = makePicture(request, curves, hasImage = false)
        for (line in picture.plot.lines) line.strokes.move(frame.left, frame.top)
        return picture
    }

    /** Returns the legend of [lines]; empty for a single line with the graph's name, unless there is a cursor. */
    private fun legendOf(graph: BoardGraph, lines: List<DrawnLine>): List<LegendEntry> {
        val isNamed = lines.singleOrNull()?.signal?.name.let { it != null && (it == graph.title || it.endsWith("/" + graph.title)) }
        if (isNamed && cursors.x == null) return emptyList()
        return lines.map { line ->
            val name = line.title.takeUnless { isNamed }.orEmpty()
            LegendEntry(listOfNotNull(name, line.label, valueOf(line)).filter { it.isNotEmpty() }.joinToString(" "), colorOf(line))
        }
    }

    private fun colorOf(line: DrawnLine) = line.color.takeIf { line.signal.states == null }

    /** Returns the value of [line] at the cursor, with its unit. */
    private fun valueOf(line: DrawnLine): String? {
        val read = line.signal.line
        val cursor = cursors.x ?: return null
        return "${read.textOf(read.indexAt(cursor - line.offset))} ${unitText(line.signal.unit)}".trim()
    }

    private fun drawXy(sheet: Sheet, graph: BoardGraph) {
        if (Thread.interrupted()) throw InterruptedException()
        val picture = xyPictureOf(graph, recordings)
        val field = picture.full.takeIf { picture.isField }
        val height = if (field == null) sheet.width / 2 else PlotMargins.heightOf(field, sheet.width)
        val density = sheet.pen.density
        val frame = PlotMargins.frameOf(sheet.width, height, x, density)
        val plane = picture.seen(graph.plane, frame.width, frame.height) ?: return
        sheet.graphHead(Board(board).titleOf(graph), unit = "", picture.legend(graph.hidden, Cursors(pinned = cursors.x)))
        sheet.part(height.toDouble()) { pen ->
            pen.moved(frame.left, frame.top) {
                val seen = XyFrame(pen, plane, frame.width, frame.height, colors)
                picture.draw(seen, graph.hidden, x, picture.groundOf(recordings), axesFrom = frame.left)
                picture.drawCursors(seen, graph.hidden, cursors)
            }
        }
    }
}
