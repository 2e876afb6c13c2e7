package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.view.Scene
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.mark.EventMarks
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/** Draws the marks of the events of [span] on the time line of a plot. */
internal fun drawEventMarks(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span = scene.range.now) {
    if (scene.events.placedCount == 0) return
    val ratio = window.devicePixelRatio
    val head = HEAD * ratio
    marks.place(scene.events, span, frame.width, ratio)
    fun path(add: (Int, Double) -> Unit) {
        context.beginPath()
        for (i in 0 until marks.size) add(i, frame.left + marks.pixelOf(i) + 0.5)
    }
    fun lines(isSerious: Boolean) {
        path { i, pixel ->
            if (marks.hasLine(i) && marks.isSerious(i) == isSerious) {
                context.moveTo(pixel, frame.top)
                context.lineTo(pixel, frame.bottom)
            }
        }
        context.stroke()
    }
    context.save()
    context.fillStyle = scene.palette[Shade.EVENT]
    context.strokeStyle = scene.palette[Shade.EVENT]
    context.lineWidth = 1.0
    context.globalAlpha = LINE_OPACITY
    lines(isSerious = false)
    context.globalAlpha = SERIOUS_OPACITY
    lines(isSerious = true)
    path { i, pixel -> if (!marks.hasHead(i)) context.rect(pixel - ratio / 2, frame.top, ratio, head) }
    context.fill()
    context.globalAlpha = 1.0
    path { i, pixel ->
        if (marks.hasHead(i)) {
            context.moveTo(pixel - head, frame.top)
            context.lineTo(pixel + head, frame.top)
            context.lineTo(pixel, frame.top + head * 1.5)
            context.closePath()
        }
    }
    context.fill()
    context.restore()
}

/** Shared by all plots, which are drawn one after another. */
private val marks = EventMarks()

private const val HEAD = 3.5
private const val LINE_OPACITY = 0.2
private const val SERIOUS_OPACITY = 0.5
