package badlog.viewer.compare

import badlog.viewer.app.Viewer

/** What graphs draw, the open recording first. */
internal fun Viewer.drawnRecordings(): List<DrawnRecording> = listOfNotNull(open?.let(::DrawnRecording))
