package badlog.viewer.export.figure

import badlog.analysis.PixelColumns
import badlog.analysis.Span
import badlog.analysis.Units
import badlog.plot.axis.limitsFor
import badlog.plot.board.BoardGraph
import badlog.plot.curve.Curve
import badlog.plot.curve.Scale
import badlog.plot.curve.Strokes
import badlog.plot.timeline.EventTimeline
import badlog.plot.timeline.FindingTimeline
import badlog.recording.PathName
import badlog.rules.Finding
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.graph.plot.drawnLines
import badlog.viewer.recording.Signal
import badlog.viewer.theme.Palette

/**
 * Makes a [Figure] of what [recordings] have between [x], each moved by its offset: the first is the open one. What the
 * recordings lack is left out. Reads samples, so it is not for the window's thread; interrupting its thread
 * stops it.
 *
 * @param width how many pixels wide the figure will be.
 * @param events those of the open recording that are marked.
 * @param findings what rules found in it, if that is known.
 */
internal class FigureBuilder(
    private val recordings: List<DrawnRecording>,
    private val x: Span,
    private val width: Int,
    private val events: EventTimeline = EventTimeline.NONE,
    private val findings: FindingTimeline<Finding>? = null,
) {
    private val names = recordings.map { it.name }
    private val frameLetters = width / FRAME_LETTER

    /** One line of one recording. */
    private class Source(val drawn: DrawnRecording, val signal: Signal, val title: String, val label: String, val color: Int)

    private class GraphSources(val graph: BoardGraph, val sources: List<Source>)

    /** The figure of [graphs]; a graph without any line in any of the recordings has no frame. */
    fun build(graphs: List<BoardGraph>): Figure {
        val sources = graphs.map { GraphSources(it, sourcesOf(it)) }.filter { it.sources.isNotEmpty() }
        val axis = recordings.first().recording.view.xAxis
        val lineCount = sources.sumOf { graph -> graph.sources.count { it.signal.states == null } }
        val laneCount = sources.sumOf { it.sources.size } - lineCount
        val columns = PixelColumns(shareOf(MAX_POINTS / POINTS_PER_COLUMN, lineCount))
        val laneColumns = shareOf(MAX_BLOCKS / BLOCKS_PER_COLUMN, laneCount)
        return Figure(
            title = plainLine(names.joinToString(" · "), width / TITLE_LETTER),
            xTitle = plainLine(axis.title, NAME_LETTERS),
            x = x,
            frames = sources.flatMap { framesOf(it, columns, laneColumns) },
            marks = figureMarks(x, width, recordings.first().recording.modes, events, findings),
        )
    }

    private fun shareOf(all: Int, count: Int) = (all / maxOf(count, 1)).coerceIn(MIN_COLUMNS, maxOf(width, MIN_COLUMNS))

    // The colors are those of the window, and so is what a person has hidden.
    private fun sourcesOf(graph: BoardGraph): List<Source> =
        drawnLines(graph, recordings).filter { it.signal.name !in graph.hidden }.map { line ->
            val place = recordings.indexOfFirst { it.recording === line.recording && it.offset == line.offset }
            Source(recordings[place], line.signal, line.title, labelOf(line.title, names[place], graph), line.color)
        }

    private fun labelOf(lineTitle: String, recording: String, graph: BoardGraph): String = when {
        recordings.size == 1 -> plainLine(lineTitle, LABEL_LETTERS)

        graph.lines.size == 1 -> plainLine(recording, LABEL_LETTERS)

        else -> {
            val title = plainLine(lineTitle, LABEL_LETTERS / 2)
            "$title, ${plainLine(recording, LABEL_LETTERS - title.length - 2)}"
        }
    }

    /** States have a frame of their own, and so has each unit: an axis shows one. */
    private fun framesOf(graph: GraphSources, columns: PixelColumns, laneColumns: Int): List<FigureFrame> {
        if (graph.graph.isXy) return listOfNotNull(xyFrame(graph.graph, recordings, x, width))
        val (states, numbers) = graph.sources.partition { it.signal.states != null }
        val units = numbers.groupBy { it.signal.unit }.values
        return units.mapIndexed { i, lines -> lineFrame(graph.graph, lines, columns, isFirst = i == 0) } +
            laneFrames(if (units.isEmpty()) graph.graph else graph.graph.copy(title = namesIn(states)), states, laneColumns)
    }

    /** What stands above a frame that is not the first of its graph, whose title was read already. */
    private fun namesIn(sources: List<Source>) = sources.map { it.title }.distinct().joinToString()

    private fun lineFrame(graph: BoardGraph, sources: List<Source>, columns: PixelColumns, isFirst: Boolean): FigureFrame {
        var least = Double.NaN
        var most = Double.NaN
        val lines = sources.map { source ->
            if (Thread.interrupted()) throw InterruptedException()
            val curve = Curve(source.signal.series, source.drawn.recording.holdsUntil(source.signal))
            val offset = source.drawn.offset
            curve.draw(x.from - offset, x.to - offset, columns)
            if (!(least <= curve.min)) least = if (curve.min.isNaN()) least else curve.min
            if (!(most >= curve.max)) most = if (curve.max.isNaN()) most else curve.max
            val strokes = Strokes().apply { trace(curve, Scale(0.0, 1.0, 1.0, start = offset), Scale.NONE) }
            FigureLine(source.label, hexOf(Palette.LIGHT.line(source.color)), strokes)
        }
        val wanted = graph.yRange?.takeIf { isFirst && it.width > 0 }
        val unit = sources.first().signal.unit
        val title = if (isFirst) graph.title else namesIn(sources)
        val saysItAll = sources.size == 1 && (!isFirst || isNamed(graph, sources[0].signal))
        return FigureFrame(
            title = plainLine(title, frameLetters),
            yTitle = if (Units.isNone(unit)) "" else plainLine(unit, UNIT_LETTERS),
            y = wanted ?: limitsFor(least, most, graph.includesZero),
            isFilled = graph.isFilled,
            hasLegend = recordings.size > 1 || !saysItAll,
            lines = lines,
            lanes = emptyList(),
        )
    }

    /** Of several recordings the lanes of one signal stand together, as they are to be compared. */
    private fun laneFrames(graph: BoardGraph, sources: List<Source>, columns: Int): List<FigureFrame> = when {
        sources.isEmpty() -> emptyList()

        recordings.size == 1 -> listOf(laneFrame(graph.title, sources, columns) { it.title })

        else -> sources.groupBy { it.signal.name }.map { (name, lanes) ->
            laneFrame(name, lanes, columns) { names[recordings.indexOf(it.drawn)] }
        }
    }

    private fun laneFrame(title: String, sources: List<Source>, columns: Int, label: (Source) -> String) = FigureFrame(
        title = plainLine(title, frameLetters),
        yTitle = "",
        y = Span(0.0, sources.size.toDouble()),
        isFilled = false,
        hasLegend = false,
        lines = emptyList(),
        lanes = sources.map { source ->
            FigureLane(plainLine(label(source), LANE_LETTERS), figureBlocks(source.signal, source.drawn, x, columns))
        },
    )

    private fun isNamed(graph: BoardGraph, signal: Signal) = graph.title == signal.name || PathName.baseNameOf(graph.title) == signal.title

    private companion object {
        /** So many points make about one megabyte of SVG. */
        const val MAX_POINTS = 70_000
        const val POINTS_PER_COLUMN = 4
        const val MAX_BLOCKS = 4_000
        const val BLOCKS_PER_COLUMN = 2
        const val MIN_COLUMNS = 40
        const val TITLE_LETTER = 14
        const val FRAME_LETTER = 11
        const val NAME_LETTERS = 60

        /** Longer ones are broken by lets-plot. */
        const val LABEL_LETTERS = 30
        const val LANE_LETTERS = 20
        const val UNIT_LETTERS = 18
    }
}
