package badlog.page.graph

import badlog.page.view.Scene
import badlog.page.view.VisibleRange
import kotlin.math.floor
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.Path2D

/**
 * The marks of the events of [span] on the time line of a plot: never more than one for a pixel, and only a tick for
 * those that crowd behind another.
 */
internal fun drawEventMarks(
    context: CanvasRenderingContext2D,
    frame: PlotFrame,
    scene: Scene,
    span: VisibleRange.Span = scene.range.now,
) {
    val timeline = scene.events
    if (timeline.events.isEmpty()) return
    val ratio = window.devicePixelRatio
    val heads = Path2D()
    val lines = Path2D()
    val ticks = Path2D()
    var lastPixel = Double.NEGATIVE_INFINITY
    for (i in timeline.firstAtOrAfter(span.from) until timeline.events.size) {
        val event = timeline.events[i]
        if (event.x > span.to) break
        val pixel = floor(frame.pixelOfX(event.x)) + 0.5
        if (pixel - lastPixel < ratio) continue
        val isApart = pixel - lastPixel >= FEWEST_PIXELS_APART * ratio
        lastPixel = pixel
        val head = HEAD * ratio
        if (isApart) {
            heads.moveTo(pixel - head, frame.top)
            heads.lineTo(pixel + head, frame.top)
            heads.lineTo(pixel, frame.top + head * 1.5)
            heads.closePath()
            lines.moveTo(pixel, frame.top)
            lines.lineTo(pixel, frame.bottom)
        } else {
            ticks.rect(pixel - ratio / 2, frame.top, ratio, head)
        }
    }
    context.save()
    context.fillStyle = scene.palette.event
    context.strokeStyle = scene.palette.event
    context.lineWidth = 1.0
    context.globalAlpha = LINE_OPACITY
    context.stroke(lines)
    context.globalAlpha = TICK_OPACITY
    context.fill(ticks)
    context.globalAlpha = 1.0
    context.fill(heads)
    context.restore()
}

private const val HEAD = 3.5
private const val FEWEST_PIXELS_APART = 9
private const val LINE_OPACITY = 0.2
private const val TICK_OPACITY = 0.5
