package badlog.window.graph.xy

import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.path.XyLog
import badlog.viewer.draw.path.XyPicture
import badlog.window.compare.DrawnRecording
import badlog.window.pen.SkiaImage

/** Returns the picture of [graph], which draws y over x, for [recordings], the open one first. */
internal fun xyPictureOf(graph: BoardGraph, recordings: List<DrawnRecording>): XyPicture =
    XyPicture(graph.lines, graph.origin, recordings.map { XyLog(it.recording.paths, it.name, it.offset) })

/** Returns the picture of the field below the paths of [recordings]; null for none. */
internal fun XyPicture.groundOf(recordings: List<DrawnRecording>): SkiaImage? =
    parts.firstOrNull()?.let { recordings[it.index].recording.fieldPicture }
