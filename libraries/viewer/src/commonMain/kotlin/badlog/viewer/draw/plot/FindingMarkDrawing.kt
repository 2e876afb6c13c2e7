package badlog.viewer.draw.plot

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.mark.FindingGlyph
import badlog.viewer.draw.mark.FindingMarks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points

/**
 * Draws the marks of [findings] at the bottom of [frame], where there are no marks of events. A mark is a glyph below a dashed line, and
 * a band for a finding that lasts. There may be thousands, the same on all graphs.
 */
fun Pen.drawFindingMarks(frame: PlotFrame, findings: FindingTimeline<*>, colors: PenColors) {
    if (findings.places.isEmpty()) return
    layer("findings", frame.left, frame.top, frame.width, frame.height, listOf(findings, frame.shown, colors)) { pen, height ->
        val marks = FindingMarks().apply { place(findings, frame.shown, frame.width, density) }
        for (i in 0 until marks.runCount) pen.drawRun(marks, i, height, colors)
        for (i in 0 until marks.size) pen.drawMark(marks, i, height, colors)
    }
}

private fun Pen.drawRun(marks: FindingMarks, index: Int, height: Double, colors: PenColors) {
    val color = colors.severity(marks.runSeverity(index) ?: return)
    val left = marks.runFrom(index)
    val width = marks.runTo(index) - left
    rectangle(left, 0.0, width, height, faded(color, BAND_OPACITY))
    rectangle(left, height - FOOT * density, width, FOOT * density, color)
}

private fun Pen.drawMark(marks: FindingMarks, index: Int, height: Double, colors: PenColors) {
    val severity = marks.severityOf(index)
    val color = colors.severity(severity)
    val x = marks.pixelOf(index)
    if (marks.hasLine(index)) segments(Points().line(x, 0.0, x, height), faded(color, LINE_OPACITY), density, DASH * density)
    val glyph = FindingGlyph.of(severity)
    val reach = FindingGlyph.SIZE * density
    val middle = height - reach - density
    if (glyph.isHollow) {
        dots(Points().add(x, middle), reach - density, colors[Shade.SURFACE])
        return ring(x, middle, reach - density, color, RING * density)
    }
    val outline = Points()
    for (at in glyph.outline.indices step 2) outline.add(x + glyph.outline[at] * reach, middle + glyph.outline[at + 1] * reach)
    shapes(outline, glyph.outline.size / 2, color)
    // This edge separates two marks that touch.
    chain(outline, isClosed = true, colors[Shade.SURFACE], density)
}

private const val FOOT = 3.0
private const val DASH = 3.0
private const val RING = 1.8
private const val BAND_OPACITY = 0.13
private const val LINE_OPACITY = 0.6
