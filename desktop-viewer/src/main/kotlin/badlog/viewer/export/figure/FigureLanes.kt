package badlog.viewer.export.figure

import badlog.analysis.Span
import badlog.analysis.StateRuns
import badlog.plot.lane.laneBlocks
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.graph.plot.laneColour
import badlog.viewer.recording.Signal
import badlog.viewer.theme.Palette

/** The states of [signal] in [drawn] within [x], as the screen would show them in a lane of [columns] pixels. */
internal fun figureBlocks(signal: Signal, drawn: DrawnRecording, x: Span, columns: Int): List<FigureBlock> {
    val names = signal.states.orEmpty()
    val runs = StateRuns(signal.series, drawn.recording.span.to)
    val own = Span(x.from - drawn.offset, x.to - drawn.offset)
    val column = x.width / columns
    return laneBlocks(runs, own, columns.toDouble(), SHORTEST).map { block ->
        FigureBlock(
            from = x.from + block.left * column,
            to = x.from + block.right * column,
            name = plainLine(names.getOrElse(block.state) { "?" }, NAME_LETTERS),
            colour = hexOf(laneColour(names, block.state, Palette.LIGHT, narrow = block.width <= NARROW)),
        )
    }
}

/** In columns, each of which is one to four points of the figure wide. */
private const val SHORTEST = 1
private const val NARROW = 3.0
private const val NAME_LETTERS = 60
