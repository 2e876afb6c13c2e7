package badlog.window.export.figure

import badlog.core.analysis.Span
import badlog.core.analysis.StateRuns
import badlog.viewer.draw.lane.LaneBlocks
import badlog.viewer.draw.lane.LaneTone
import badlog.window.compare.DrawnRecording
import badlog.window.graph.plot.laneColor
import badlog.window.log.Signal
import badlog.window.theme.Palette

/** Returns the states of [signal] in [drawn] within [x], as the screen would show them in a lane of [columns] pixels. */
internal fun figureBlocks(signal: Signal, drawn: DrawnRecording, x: Span, columns: Int): List<FigureBlock> {
    val names = signal.states.orEmpty()
    val runs = StateRuns(signal.series, drawn.recording.span.to)
    val own = Span(x.from - drawn.offset, x.to - drawn.offset)
    val column = x.width / columns
    val blocks = LaneBlocks().apply { place(runs, own, columns.toDouble(), MIN_BLOCK) }
    return List(blocks.size) { i ->
        val tone = LaneTone.of(names, blocks.states[i], blocks.right[i] - blocks.left[i])
        FigureBlock(
            from = x.from + blocks.left[i] * column,
            to = x.from + blocks.right[i] * column,
            name = plainLine(names.getOrElse(blocks.states[i]) { "?" }, NAME_LETTERS),
            color = hexOf(laneColor(tone, blocks.states[i], Palette.LIGHT)),
        )
    }
}

/** In columns, each of which is one to four points of the figure wide. */
private const val MIN_BLOCK = 1
private const val NAME_LETTERS = 60
