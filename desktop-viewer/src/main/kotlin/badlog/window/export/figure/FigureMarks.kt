package badlog.window.export.figure

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.draw.mark.EventMarks
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingMarks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.shown.cursor.Cursors
import badlog.window.findings.findingColor
import badlog.window.theme.Palette

/**
 * What every frame of a figure shows of the open recording besides its lines, as the screen does.
 *
 * @property bands when the robot was enabled.
 * @property events where something happened.
 * @property findings where rules found something.
 * @property notes where a person wrote a note.
 * @property cursors where values are read.
 */
internal class FigureMarks(
    val bands: List<FigureBand> = emptyList(),
    val events: List<Double> = emptyList(),
    val findings: List<FigurePoint> = emptyList(),
    val notes: List<Double> = emptyList(),
    val cursors: List<Double> = emptyList(),
)

/** A stretch of x behind the lines; [color] as `#rrggbb`. */
internal class FigureBand(val from: Double, val to: Double, val color: String)

/** A mark at [x]; [color] as `#rrggbb`. */
internal class FigurePoint(val x: Double, val color: String)

/** Returns the marks of a figure of [x], [width] pixels wide; crowded ones are omitted, as on the screen. */
internal fun figureMarks(
    x: Span,
    width: Int,
    modes: ModeTimeline,
    events: EventTimeline,
    findings: FindingTimeline<Finding>?,
    notes: List<Double>,
    cursors: Cursors,
): FigureMarks {
    fun placeOf(pixel: Double) = x.from + pixel / width * x.width
    val bands = modes.spans.filter { it.span.from < x.to && it.span.to > x.from }.map { stretch ->
        FigureBand(maxOf(x.from, stretch.span.from), minOf(x.to, stretch.span.to), hexOf(Palette.LIGHT.mode(stretch.mode)))
    }
    val eventMarks = EventMarks().apply { place(events, x, width.toDouble(), 1.0) }
    val findingMarks = FindingMarks()
    findings?.let { findingMarks.place(it, x, width.toDouble(), 1.0) }
    return FigureMarks(
        bands = bands,
        events = (0 until eventMarks.size).filter(eventMarks::hasLine).map { placeOf(eventMarks.pixelOf(it)) },
        findings = List(findingMarks.size) {
            FigurePoint(placeOf(findingMarks.pixelOf(it)), hexOf(Palette.LIGHT.findingColor(findingMarks.severityOf(it))))
        },
        notes = notes.filter { it in x },
        cursors = listOfNotNull(cursors.x, cursors.second).filter { it in x },
    )
}
