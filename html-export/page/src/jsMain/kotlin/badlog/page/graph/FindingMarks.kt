package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.view.Scene
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.mark.FindingGlyph
import badlog.viewer.draw.mark.FindingMarks
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import kotlin.math.PI

/**
 * Draws the marks of the findings of [span] at the bottom of a plot, where there are no marks of events: a glyph below a dashed line,
 * and a band for findings that last.
 */
internal fun drawFindingMarks(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span = scene.range.now) {
    if (scene.findings.places.isEmpty()) return
    picture.putOn(context, frame, scene, span)
}

/** The picture of all marks, of which there may be thousands. */
private class MarksPicture {
    private val pictures = KeptPictures()
    private val marks = FindingMarks()

    fun putOn(target: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span) {
        val (width, height) = frame.width to frame.height
        pictures.putOn(target, frame.left, frame.top, width, height, scene.findings, span, scene.palette[Shade.SURFACE]) { context, drawn ->
            val ratio = window.devicePixelRatio
            marks.place(scene.findings, span, width, ratio)
            draw(context, PlotFrame(0.0, 0.0, width, drawn, span.from, span.to), scene, ratio)
        }
    }

    private fun draw(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, ratio: Double) {
        for (i in 0 until marks.runCount) {
            val severity = marks.runSeverity(i) ?: continue
            val width = marks.runTo(i) - marks.runFrom(i)
            context.fillStyle = scene.palette.severity(severity)
            context.globalAlpha = BAND_OPACITY
            context.fillRect(marks.runFrom(i), 0.0, width, frame.height)
            context.globalAlpha = 1.0
            context.fillRect(marks.runFrom(i), frame.bottom - FOOT * ratio, width, FOOT * ratio)
        }
        for (i in 0 until marks.size) {
            val color = scene.palette.severity(marks.severityOf(i))
            val pixel = marks.pixelOf(i)
            context.strokeStyle = color
            context.lineWidth = ratio
            if (marks.hasLine(i)) drawLine(context, pixel, frame, ratio)
            val glyph = FindingGlyph.of(marks.severityOf(i))
            context.fillStyle = if (glyph.isHollow) scene.palette[Shade.SURFACE] else color
            if (glyph.isHollow) context.lineWidth = RING * ratio
            drawGlyph(context, glyph, pixel, frame.bottom - (FindingGlyph.SIZE + 1) * ratio, FindingGlyph.SIZE * ratio)
        }
    }
}

private fun drawLine(context: CanvasRenderingContext2D, pixel: Double, frame: PlotFrame, ratio: Double) {
    context.globalAlpha = LINE_OPACITY
    context.setLineDash(arrayOf(DASH * ratio, DASH * ratio))
    context.beginPath()
    context.moveTo(pixel, frame.top)
    context.lineTo(pixel, frame.bottom)
    context.stroke()
    context.setLineDash(emptyArray())
    context.globalAlpha = 1.0
}

private fun drawGlyph(context: CanvasRenderingContext2D, glyph: FindingGlyph, x: Double, middle: Double, reach: Double) {
    context.beginPath()
    if (glyph == FindingGlyph.RING) context.arc(x, middle, reach - window.devicePixelRatio, 0.0, 2 * PI)
    var at = 0
    while (at < glyph.outline.size) {
        context.lineTo(x + glyph.outline[at] * reach, middle + glyph.outline[at + 1] * reach)
        at += 2
    }
    context.closePath()
    context.fill()
    context.stroke()
}

/** Shared by all plots, which are drawn one after another. Created when the first is drawn, because workers have no canvas. */
private val picture by lazy { MarksPicture() }

private const val FOOT = 3.0
private const val DASH = 3.0
private const val RING = 1.8
private const val BAND_OPACITY = 0.13
private const val LINE_OPACITY = 0.6
