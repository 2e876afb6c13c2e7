package badlog.viewer.takeaway.cut

import badlog.plot.Span
import badlog.viewer.recording.OpenRecording

/**
 * The rows of [recording] from the first to the last whose x lies in [span]; empty when there is none. Where x is missing or
 * goes backwards, rows between them belong to it too: a cut keeps the file's order and leaves nothing out.
 */
internal fun rowsWithin(recording: OpenRecording, span: Span): IntRange {
    val positions = recording.view.xAxis.positions
    val first = positions.indexOfFirst { it in span }
    return if (first < 0) IntRange.EMPTY else first..positions.indexOfLast { it in span }
}
