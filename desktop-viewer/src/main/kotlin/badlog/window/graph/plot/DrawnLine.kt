package badlog.window.graph.plot

import badlog.core.analysis.GraphSeries
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.plot.GraphLine
import badlog.viewer.shown.comparison.colorOf
import badlog.viewer.text.shortNames
import badlog.window.compare.DrawnRecording
import badlog.window.log.DrawableTopic
import badlog.window.log.OpenRecording

/**
 * One line on the screen: a signal of a recording.
 *
 * @property offset the number added to the recording's x to get the window's x.
 * @property color the index of its color in the palette, from 0.
 * @property title its name in the graph: the part of its path that distinguishes it from the other lines; in brackets if it was calculated.
 * @property label an addition to the signal's name in the legend, if that is not enough; otherwise null.
 */
internal data class DrawnLine(
    val signal: DrawableTopic,
    val recording: OpenRecording,
    override val offset: Double,
    override val color: Int,
    val title: String = signal.title,
    val label: String? = null,
) : GraphLine {
    override val series: GraphSeries get() = signal.line
}

/** Returns the lines of [spec] in each of [recordings] that has them. */
internal fun drawnLines(spec: BoardGraph, recordings: List<DrawnRecording>): List<DrawnLine> {
    val isCompared = recordings.size > 1
    val titles = shortNames(spec.lines)
    return spec.lines.flatMapIndexed { place, name ->
        recordings.mapIndexedNotNull { index, drawn ->
            val signal = drawn.recording.signal(name) ?: return@mapIndexedNotNull null
            DrawnLine(
                signal = signal,
                recording = drawn.recording,
                offset = drawn.offset,
                color = colorOf(place, index, recordings.size),
                title = if (signal.isDerived) "[ ${titles[place]} ]" else titles[place],
                label = if (isCompared) drawn.name else null,
            )
        }
    }
}
