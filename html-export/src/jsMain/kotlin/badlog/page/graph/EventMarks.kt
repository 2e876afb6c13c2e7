package badlog.page.graph

import badlog.analysis.Span
import badlog.page.view.Scene
import badlog.plot.color.Shade
import badlog.plot.timeline.EventMarks
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.Path2D

/** Draws the marks of the events of [span] on the time line of a plot. */
internal fun drawEventMarks(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span = scene.range.now) {
    if (scene.events.placedCount == 0) return
    val ratio = window.devicePixelRatio
    val head = HEAD * ratio
    val heads = Path2D()
    val lines = Path2D()
    val seriousLines = Path2D()
    val ticks = Path2D()
    marks.place(scene.events, span, frame.width, ratio)
    for (i in 0 until marks.size) {
        val pixel = frame.left + marks.pixelOf(i) + 0.5
        if (marks.hasHead(i)) {
            heads.moveTo(pixel - head, frame.top)
            heads.lineTo(pixel + head, frame.top)
            heads.lineTo(pixel, frame.top + head * 1.5)
            heads.closePath()
        } else {
            ticks.rect(pixel - ratio / 2, frame.top, ratio, head)
        }
        if (marks.hasLine(i)) {
            val path = if (marks.isSerious(i)) seriousLines else lines
            path.moveTo(pixel, frame.top)
            path.lineTo(pixel, frame.bottom)
        }
    }
    context.save()
    context.fillStyle = scene.palette[Shade.EVENT]
    context.strokeStyle = scene.palette[Shade.EVENT]
    context.lineWidth = 1.0
    context.globalAlpha = LINE_OPACITY
    context.stroke(lines)
    context.globalAlpha = SERIOUS_OPACITY
    context.stroke(seriousLines)
    context.fill(ticks)
    context.globalAlpha = 1.0
    context.fill(heads)
    context.restore()
}

/** One for all plots, which are drawn one after another. */
private val marks = EventMarks()

private const val HEAD = 3.5
private const val LINE_OPACITY = 0.2
private const val SERIOUS_OPACITY = 0.5
