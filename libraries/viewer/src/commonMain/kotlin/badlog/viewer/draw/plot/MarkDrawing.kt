package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.color.modeOpacity
import badlog.viewer.draw.color.modeShade
import badlog.viewer.draw.mark.EventMarks
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.draw.mark.FindingGlyph
import badlog.viewer.draw.mark.FindingMarks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.ModeBands
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points
import badlog.viewer.shown.cursor.Cursors

/**
 * Shades the parts of [frame] in which the robot was enabled, by its mode. If [hasNames] is true, each mode's name is written where there
 * is room.
 */
fun Pen.drawModes(frame: PlotFrame, modes: ModeTimeline, colors: PenColors, hasNames: Boolean = false) {
    if (modes.spans.isEmpty()) return
    val bands = ModeBands().apply { place(modes, frame.shown, frame.width) }
    for (i in 0 until bands.size) {
        val left = frame.left + bands.leftOf(i)
        val width = bands.rightOf(i) - bands.leftOf(i)
        val mode = bands.modeOf(i)
        rectangle(left, frame.top, width, frame.height, faded(colors[modeShade(mode)], modeOpacity(colors.isDark)))
        if (!hasNames || widthOf(mode.title, AXIS_LETTERS * density) > width - 2 * MARGIN * density) continue
        text(mode.title, left + MARGIN * density, frame.top + frame.height / 2, AXIS_LETTERS * density, colors[Shade.MUTED])
    }
}

/**
 * Draws the marks of [events] along the top of [frame]: heads and, in crowds, ticks. If [hasLines] is true, heads have lines down to the
 * bottom.
 */
fun Pen.drawEventMarks(frame: PlotFrame, events: EventTimeline, colors: PenColors, hasLines: Boolean = true) {
    if (events.placedCount == 0) return
    val marks = EventMarks().apply { place(events, frame.shown, frame.width, density) }
    val color = colors[Shade.EVENT]
    val head = HEAD * density
    val lines = Points()
    for (isSerious in listOf(false, true)) {
        lines.clear()
        for (i in 0 until marks.size) {
            val x = frame.left + marks.pixelOf(i) + 0.5
            if (hasLines && marks.hasLine(i) && marks.isSerious(i) == isSerious) lines.line(x, frame.top, x, frame.bottom)
        }
        segments(lines, faded(color, if (isSerious) SERIOUS_OPACITY else NOTE_OPACITY), 0.0)
    }
    val ticks = Points()
    val heads = Points()
    for (i in 0 until marks.size) {
        val x = frame.left + marks.pixelOf(i) + 0.5
        if (marks.hasHead(i)) {
            heads.add(x - head, frame.top).add(x + head, frame.top).add(x, frame.top + head * 1.5)
        } else {
            ticks.line(x, frame.top, x, frame.top + head)
        }
    }
    segments(ticks, faded(color, SERIOUS_OPACITY), density)
    shapes(heads, TRIANGLE, color)
}

/** Draws a line and a flag at each of [places], the places of notes. */
fun Pen.drawNoteMarks(frame: PlotFrame, places: List<Double>, colors: PenColors) {
    for (x in places) {
        if (x !in frame.shown) continue
        val left = frame.x.placeOf(x)
        rectangle(left, frame.top, density, frame.height, colors[Shade.ACCENT])
        rectangle(left, frame.top, FLAG_WIDTH * density, FLAG_HEIGHT * density, colors[Shade.ACCENT])
    }
}

private const val MARGIN = 5.0
private const val HEAD = 3.5
private const val TRIANGLE = 3
private const val NOTE_OPACITY = 0.2
private const val SERIOUS_OPACITY = 0.5
private const val FLAG_WIDTH = 9
private const val FLAG_HEIGHT = 6

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
    if (marks.hasLine(index)) segments(Points().line(x, 0.0, x, height), faded(color, LINE_OPACITY), density, MARK_DASH * density)
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
private const val MARK_DASH = 3.0
private const val RING = 1.8
private const val BAND_OPACITY = 0.13
private const val LINE_OPACITY = 0.6

/** Draws [cursors] over the height of [frame]: the pinned one, the second one dashed, and the pointer's place thin. */
fun Pen.drawCursors(frame: PlotFrame, cursors: Cursors, colors: PenColors) {
    val accent = colors[Shade.ACCENT]
    val pointer = faded(colors[Shade.CURSOR], if (cursors.isPinned) POINTER_OPACITY else CURSOR_OPACITY)
    drawLine(frame, cursors.hover, pointer, density)
    drawLine(frame, cursors.pinned, accent, PINNED * density)
    drawLine(frame, cursors.second, accent, PINNED * density, DASH * density)
}

private fun Pen.drawLine(frame: PlotFrame, x: Double?, color: Int, width: Double, dash: Double = 0.0) {
    if (x == null || x !in frame.shown) return
    val place = frame.x.placeOf(x)
    segments(Points().line(place, frame.top, place, frame.bottom), color, width, dash)
}

/** Draws a dot at ([x], [y]), in pixels, in the color of line [color]. */
internal fun Pen.drawSample(x: Double, y: Double, color: Int, colors: PenColors) {
    val place = Points().add(x, y)
    dots(place, (DOT + 1) * density, colors[Shade.SURFACE])
    dots(place, DOT * density, colors.line(color))
}

private const val CURSOR_OPACITY = 0.75
private const val POINTER_OPACITY = 0.4
private const val PINNED = 2.0
private const val DASH = 4.0
private const val DOT = 3.0

/** Draws [range], a selected part of x, as a band over the height of [frame], with its edges. */
fun Pen.drawSelection(frame: PlotFrame, range: Span, colors: PenColors) {
    drawBand(frame, range, faded(colors[Shade.ACCENT], SELECTED_OPACITY))
    val edges = Points()
    for (edge in listOf(range.from, range.to)) {
        if (edge in frame.shown) frame.x.placeOf(edge).let { edges.line(it, frame.top, it, frame.bottom) }
    }
    segments(edges, colors[Shade.ACCENT], density)
}

/** Draws a selected part of y, from [top] to [bottom] in pixels, as a band over the width of [frame], with its edges. */
fun Pen.drawSelectedHeights(frame: PlotFrame, top: Double, bottom: Double, colors: PenColors) {
    rectangle(frame.left, top, frame.width, bottom - top, faded(colors[Shade.ACCENT], SELECTED_OPACITY))
    val edges = Points().line(frame.left, top, frame.right, top).line(frame.left, bottom, frame.right, bottom)
    segments(edges, colors[Shade.ACCENT], density)
}

/** Shades the time of [finding] over the height of [frame], between dashed lines if there is room for them. */
fun Pen.drawFinding(frame: PlotFrame, finding: Finding, colors: PenColors) {
    val color = colors.severity(finding.severity)
    val edges = Points()

    fun edge(x: Double) {
        if (x in frame.shown) frame.x.placeOf(x).let { edges.line(it, frame.top, it, frame.bottom) }
    }
    for (span in finding.spans) {
        drawBand(frame, span, faded(color, FOUND_OPACITY))
        if (span.width / frame.shown.width * frame.width >= MIN_FOUND_WIDTH * density) edge(span.to)
        edge(span.from)
    }
    if (finding.spans.isEmpty()) edge(finding.time)
    segments(edges, faded(color, EDGE_OPACITY), density, DASH * density)
}

/** Draws the [visible] part of a log as an outline with handles, and shades the rest. [frame] shows the whole log. */
fun Pen.drawVisible(frame: PlotFrame, visible: Span, colors: PenColors) {
    val least = MIN_WIDTH * density
    val center = frame.x.placeOf(visible.from + visible.width / 2)
    val half = maxOf(frame.x.placeOf(visible.to) - center, least / 2)
    val left = center - half
    val right = center + half
    val shade = faded(colors[Shade.PAGE], SHADED_OPACITY)
    rectangle(frame.left, frame.top, maxOf(0.0, left - frame.left), frame.height, shade)
    rectangle(right, frame.top, maxOf(0.0, frame.right - right), frame.height, shade)
    val outline = roundedBox(left, frame.top + 0.5, right - left, frame.height - 1, RADIUS * density)
    chain(outline, isClosed = true, colors[Shade.ACCENT], OUTLINE * density)
    // Only with room between the edges for handles.
    if (right - left < 4 * least) return
    val handles = Points()
    for (edge in listOf(left, right)) {
        handles.line(edge, frame.top + HANDLE_FROM * frame.height, edge, frame.top + (1 - HANDLE_FROM) * frame.height)
    }
    segments(handles, colors[Shade.ACCENT], HANDLE * density)
}

private fun Pen.drawBand(frame: PlotFrame, span: Span, color: Int) {
    val left = frame.x.placeOf(span.from).coerceIn(frame.left, frame.right)
    val right = frame.x.placeOf(span.to).coerceIn(frame.left, frame.right)
    if (right > left) rectangle(left, frame.top, right - left, frame.height, color)
}

private const val SELECTED_OPACITY = 0.16
private const val FOUND_OPACITY = 0.12
private const val EDGE_OPACITY = 0.6
private const val SHADED_OPACITY = 0.65
private const val MIN_WIDTH = 5
private const val MIN_FOUND_WIDTH = 6
private const val RADIUS = 3.0
private const val OUTLINE = 1.5
private const val HANDLE = 4.0
private const val HANDLE_FROM = 0.3

/** Draws [marks] over a whole log as a strip in [frame]. Modes with their names are first, then the [lines], events, findings and notes. */
fun Pen.drawOverview(frame: PlotFrame, marks: PlotMarks, colors: PenColors, lines: () -> Unit = {}) {
    drawModes(frame, marks.modes, colors, hasNames = true)
    lines()
    drawEventMarks(frame, marks.events, colors, hasLines = false)
    marks.findings?.let { drawFindingMarks(frame, it, colors) }
    drawNoteMarks(frame, marks.notes, colors)
}
