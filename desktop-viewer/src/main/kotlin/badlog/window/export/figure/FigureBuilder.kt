package badlog.window.export.figure

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.core.recording.PathName
import badlog.rules.Finding
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.axis.GraphAxis
import badlog.viewer.draw.axis.SeenOfUnit
import badlog.viewer.draw.axis.axisLimits
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.axis.seenTogether
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.figure.FigureNotes
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.window.compare.DrawnRecording
import badlog.window.graph.plot.drawnLines
import badlog.window.log.Signal
import badlog.window.theme.Palette

/**
 * Makes a [Figure] of [recordings] in the range [x], each moved by its offset: the first is the open one. What the
 * recordings lack is omitted. It reads samples, so do not use it on the window's thread; interrupting its thread stops
 * it.
 *
 * @param width the width of the figure in pixels.
 * @param events the events of the open recording to mark.
 * @param findings its findings, if known.
 * @param notes where a person wrote a note, on its x.
 * @param board all graphs of the screen: some may share y limits with those in the figure.
 * @param cursors where on the open recording's x values are read for the legends.
 */
internal class FigureBuilder(
    private val recordings: List<DrawnRecording>,
    private val x: Span,
    private val width: Int,
    private val events: EventTimeline = EventTimeline.NONE,
    private val findings: FindingTimeline<Finding>? = null,
    private val notes: List<Double> = emptyList(),
    private val board: List<BoardGraph> = emptyList(),
    private val cursors: Cursors = Cursors(),
) {
    private val names = recordings.map { it.name }
    private val frameLetters = width / FRAME_LETTER

    /** One line of one recording. */
    private class Source(val drawn: DrawnRecording, val signal: Signal, val title: String, val label: String, val color: Int)

    private class GraphSources(val graph: BoardGraph, val sources: List<Source>)

    /** Returns the figure of [graphs]; a graph without any line in any of the recordings has no frame. */
    fun build(graphs: List<BoardGraph>): Figure {
        val sources = graphs.map { GraphSources(it, sourcesOf(it)) }.filter { it.sources.isNotEmpty() }
        val axis = recordings.first().recording.view.xAxis
        val lineCount = sources.sumOf { graph -> graph.sources.count { it.signal.states == null } }
        val laneCount = sources.sumOf { it.sources.size } - lineCount
        val columns = PixelColumns(shareOf(MAX_POINTS / POINTS_PER_COLUMN, lineCount))
        val laneColumns = shareOf(MAX_BLOCKS / BLOCKS_PER_COLUMN, laneCount)
        val shared = sharedBy(graphs, columns)
        return Figure(
            title = plainLine(names.joinToString(" · "), width / TITLE_LETTER),
            xTitle = plainLine(axis.title, NAME_LETTERS),
            x = x,
            frames = sources.flatMap { framesOf(it, columns, laneColumns, shared) },
            marks = figureMarks(x, width, recordings.first().recording.modes, events, findings, notes, cursors),
            notes = with(recordings.first().recording) { FigureNotes.of("${file.fileName}", axis, x, cursors, clocks, findings) },
        )
    }

    private fun shareOf(all: Int, count: Int) = (all / maxOf(count, 1)).coerceIn(MIN_COLUMNS, maxOf(width, MIN_COLUMNS))

    // Colors and hidden lines are the same as in the window.
    private fun sourcesOf(graph: BoardGraph): List<Source> =
        drawnLines(graph, recordings).filter { it.signal.name !in graph.hidden }.map { line ->
            val place = recordings.indexOfFirst { it.recording === line.recording && it.offset == line.offset }
            Source(recordings[place], line.signal, line.title, labelOf(line.title, names[place], graph), line.color)
        }

    /** Returns [label] in at most [letters] letters, with the value at the cursor where that is placed. */
    private fun labelOf(label: String, source: Source, letters: Int): String {
        val x = cursors.x ?: return plainLine(label, letters)
        val line = source.signal.line
        val value = plainLine(line.textOf(line.indexAt(x - source.drawn.offset), source.signal::numberText), letters / 2)
        return "${plainLine(label, letters - value.length - 1)} $value"
    }

    private fun labelOf(lineTitle: String, recording: String, graph: BoardGraph): String = when {
        recordings.size == 1 -> plainLine(lineTitle, LABEL_LETTERS)

        graph.lines.size == 1 -> plainLine(recording, LABEL_LETTERS)

        else -> {
            val title = plainLine(lineTitle, LABEL_LETTERS / 2)
            "$title, ${plainLine(recording, LABEL_LETTERS - title.length - 2)}"
        }
    }

    /** Returns what is visible of each unit in all graphs that share y limits, if one of [graphs] does. */
    private fun sharedBy(graphs: List<BoardGraph>, columns: PixelColumns): Map<String, SeenOfUnit> {
        if (graphs.none { it.sharesY }) return emptyMap()
        val sharing = (graphs + board).distinctBy { it.id }.filter { it.sharesY && !it.isXy }
        return seenTogether(sharing.flatMap { linesOfUnits(numbersOf(sourcesOf(it)), columns) }.map { it.seen })
    }

    private fun numbersOf(sources: List<Source>) = sources.filter { it.signal.states == null }

    /** States have a separate frame, and so has each unit, since an axis shows only one. */
    private fun framesOf(
        graph: GraphSources,
        columns: PixelColumns,
        laneColumns: Int,
        shared: Map<String, SeenOfUnit>,
    ): List<FigureFrame> {
        if (graph.graph.isXy) return listOfNotNull(xyFrame(graph.graph, recordings, x, width, cursors))
        val numbers = linesOfUnits(numbersOf(graph.sources), columns)
        val wholes = numbers.map { lines ->
            val seen = shared[lines.axis.unit].takeIf { graph.graph.sharesY } ?: lines.seen
            limitsFor(seen.least, seen.most, graph.graph.includesZero)
        }
        val limits = axisLimits(numbers.map { it.axis }, wholes, graph.graph.yRange, graph.graph.rightYRange)
        val states = graph.sources.filter { it.signal.states != null }
        return numbers.mapIndexed { i, lines -> lineFrame(graph.graph, lines, limits[i], isFirst = i == 0) } +
            laneFrames(if (numbers.isEmpty()) graph.graph else graph.graph.copy(title = namesIn(states)), states, laneColumns)
    }

    /** The lines of one unit, and what is visible of them. */
    private class LinesOfUnit(val axis: GraphAxis, val sources: List<Source>, val lines: List<FigureLine>, val seen: SeenOfUnit)

    private fun linesOfUnits(numbers: List<Source>, columns: PixelColumns): List<LinesOfUnit> =
        graphAxes(numbers.map { it.signal.unit }).map { axis ->
            var least = Double.NaN
            var most = Double.NaN
            val sources = axis.lines.map(numbers::get)
            val lines = sources.map { source ->
                if (Thread.interrupted()) throw InterruptedException()
                val curve = Curve(source.signal.series, source.drawn.recording.holdsUntil(source.signal))
                val offset = source.drawn.offset
                curve.draw(x.from - offset, x.to - offset, columns)
                if (!(least <= curve.min)) least = if (curve.min.isNaN()) least else curve.min
                if (!(most >= curve.max)) most = if (curve.max.isNaN()) most else curve.max
                val strokes = Strokes().apply { trace(curve, Scale(0.0, 1.0, 1.0, start = offset), Scale.NONE) }
                FigureLine(labelOf(source.label, source, LABEL_LETTERS), hexOf(Palette.LIGHT.line(source.color)), strokes)
            }
            LinesOfUnit(axis, sources, lines, SeenOfUnit(axis.unit, least, most))
        }

    /** Returns the heading of a frame that is not the first of its graph, whose title is above. */
    private fun namesIn(sources: List<Source>) = sources.map { it.title }.distinct().joinToString()

    private fun lineFrame(graph: BoardGraph, lines: LinesOfUnit, y: Span, isFirst: Boolean): FigureFrame {
        val sources = lines.sources
        val title = if (isFirst) graph.title else namesIn(sources)
        val saysItAll = sources.size == 1 && (!isFirst || isNamed(graph, sources[0].signal))
        return FigureFrame(
            title = plainLine(title, frameLetters),
            yTitle = plainLine(lines.axis.unit, UNIT_LETTERS),
            y = y,
            isFilled = graph.isFilled,
            hasLegend = recordings.size > 1 || !saysItAll || cursors.x != null,
            lines = lines.lines,
            lanes = emptyList(),
        )
    }

    /** With several recordings, the lanes of a signal are together, for comparison. */
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
            FigureLane(labelOf(label(source), source, LANE_LETTERS), figureBlocks(source.signal, source.drawn, x, columns))
        },
    )

    private fun isNamed(graph: BoardGraph, signal: Signal) = graph.title == signal.name || PathName.baseNameOf(graph.title) == signal.title

    private companion object {
        /** This many points are about one megabyte of SVG. */
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
