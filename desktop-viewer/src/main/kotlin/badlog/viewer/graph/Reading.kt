package badlog.viewer.graph

import badlog.viewer.graph.plot.DrawnLine
import badlog.viewer.graph.plot.PlotPicture
import badlog.viewer.recording.valueText

/** What [line] says at the [cursor]; empty without a cursor, and while [picture] does not have the line yet. */
internal fun readingOf(picture: PlotPicture?, line: DrawnLine, cursor: Double?): String {
    if (picture == null || cursor == null) return ""
    val isThere = picture.lines.any { it.line == line } || picture.lanes.any { it.line == line }
    return if (isThere) valueText(line.signal, cursor - line.offset) else ""
}
