package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.view.Scene
import badlog.viewer.draw.color.Shade
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/** Draws a line and a flag at each note in [span]. */
internal fun drawNoteMarks(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span = scene.range.now) {
    if (scene.notes.isEmpty()) return
    val size = window.devicePixelRatio
    context.save()
    context.fillStyle = scene.palette[Shade.ACCENT]
    for (note in scene.notes) {
        if (note.x !in span) continue
        val pixel = frame.left + (note.x - span.from) / span.width * frame.width
        context.fillRect(pixel, frame.top, size, frame.bottom - frame.top)
        context.fillRect(pixel, frame.top, FLAG_WIDTH * size, FLAG_HEIGHT * size)
    }
    context.restore()
}

private const val FLAG_WIDTH = 9
private const val FLAG_HEIGHT = 6
