package badlog.page.graph

import badlog.page.view.Scene
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import kotlin.math.round

/** Returns the frame of a plot of [width] by [height] CSS pixels. */
internal fun plotFrame(width: Int, height: Int): PlotFrame {
    val ratio = window.devicePixelRatio
    val left = round(Plot.GUTTER * ratio)
    val top = round(Plot.TOP * ratio)
    val right = round((width - Plot.RIGHT) * ratio)
    val bottom = round((height - Plot.X_AXIS_HEIGHT) * ratio)
    return PlotFrame(left, top, maxOf(1.0, right - left), bottom - top, 0.0, 1.0)
}

/** Draws [content], prepared for what [frame] shows, with its axes and all marks. */
internal fun drawPlot(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, content: PlotContent) {
    if (!content.isOpaque) drawModes(context, frame, scene)
    drawAxes(context, frame, scene, content)
    content.draw(context, frame)
    if (content.isOpaque) drawModes(context, frame, scene)
    drawFindingMarks(context, frame, scene)
    drawEventMarks(context, frame, scene)
    drawNoteMarks(context, frame, scene)
}
