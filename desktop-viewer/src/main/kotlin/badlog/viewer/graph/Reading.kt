package badlog.viewer.graph

import badlog.viewer.graph.plot.DrawnLine
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.recording.valueText

/** What [line] says at the [cursor]; empty without a cursor, and while [picture] does not have the line yet. */
internal fun readingOf(picture: PlotPicture?, line: DrawnLine, cursor: Double?): String {
    if (picture == null || cursor == null) return ""
    val series = picture.lines.firstOrNull { it.line == line }?.series
        ?: picture.lanes.firstOrNull { it.line == line }?.series
        ?: return ""
    return valueText(line.signal, series, cursor - line.offset)
}
