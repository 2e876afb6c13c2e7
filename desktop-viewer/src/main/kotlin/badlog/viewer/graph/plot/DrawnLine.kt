package badlog.viewer.graph.plot

import badlog.plot.board.BoardGraph
import badlog.plot.text.shortNames
import badlog.viewer.compare.DrawnRecording
import badlog.viewer.recording.OpenRecording
import badlog.viewer.recording.Signal

/**
 * One line on the screen: a signal of a recording.
 *
 * @property offset what is added to the recording's x to stand in the window's.
 * @property color which of the palette's colors it has, from 0.
 * @property title what the graph calls it: no more of its path than tells it from the other lines; in brackets where it was calculated.
 * @property label what the legend calls it beside the signal's name, where that is not enough; else null.
 */
internal data class DrawnLine(
    val signal: Signal,
    val recording: OpenRecording,
    val offset: Double,
    val color: Int,
    val title: String = signal.title,
    val label: String? = null,
)

/**
 * The lines of [spec] in every one of [recordings] that has them. Of one recording each line has a color; of several the
 * color shows the recording in the first place, the same in all graphs, and further lines have colors of their own.
 */
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
                color = place * recordings.size + index,
                title = if (signal.isDerived) "[ ${titles[place]} ]" else titles[place],
                label = if (isCompared) drawn.name else null,
            )
        }
    }
}
