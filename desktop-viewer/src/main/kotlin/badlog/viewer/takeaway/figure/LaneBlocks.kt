package badlog.viewer.takeaway.figure

import badlog.plot.Span
import badlog.plot.StateRuns
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.recording.Signal
import badlog.viewer.theme.Palette

/**
 * The states of [signal] in [drawn] within [x], as blocks for a lane of [columns] columns. A block is at least a column wide,
 * so that none vanishes; of many in one column the last ones of each state remain.
 */
internal fun laneBlocks(signal: Signal, drawn: DrawnRecording, x: Span, columns: Int): List<FigureBlock> {
    val names = signal.states.orEmpty()
    val runs = StateRuns(signal.series, drawn.recording.span.to)
    val column = x.width / columns
    val blocks = ArrayList<FigureBlock>()
    var drawnColumn = -1L
    val drawnStates = HashSet<Int>()
    for (run in runs.states.indices) {
        val from = maxOf(runs.from[run] + drawn.offset, x.from)
        val to = minOf(runs.to[run] + drawn.offset, x.to)
        if (!(from <= to)) continue
        val state = runs.states[run]
        val isNarrow = to - from < column
        if (isNarrow) {
            val place = ((from - x.from) / column).toLong()
            if (place != drawnColumn) drawnStates.clear()
            drawnColumn = place
            if (!drawnStates.add(state) || drawnStates.size > MOST_STATES) continue
        }
        val name = plainLine(names.getOrElse(state) { "?" }, NAME_LETTERS)
        blocks += FigureBlock(from, if (isNarrow) minOf(from + column, x.to) else to, name, colourOf(names, state, isNarrow))
    }
    return blocks
}

// False is the quiet one, as on the screen; and nobody sees a narrow block of a quiet colour.
private fun colourOf(names: List<String>, state: Int, isNarrow: Boolean): String {
    val colour = Palette.LIGHT.line(state)
    return when {
        names.size == 2 && names[0] == "false" && state == 0 -> hexOf(Palette.LIGHT.stateOff)
        isNarrow -> hexOf(colour)
        else -> hexOf(onWhite(colour, QUIET))
    }
}

private const val QUIET = 0.4f
private const val MOST_STATES = 3
private const val NAME_LETTERS = 60
