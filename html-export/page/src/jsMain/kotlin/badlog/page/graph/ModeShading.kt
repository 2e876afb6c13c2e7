package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.view.Scene
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.modeOpacity
import badlog.viewer.draw.color.modeShade
import badlog.viewer.draw.mark.ModeBands
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/** Shades the parts of [span] in which the robot was enabled, by its mode. Call it before drawing anything on top. */
internal fun drawModes(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span = scene.range.now) {
    if (scene.modes.spans.isEmpty()) return
    bands.place(scene.modes, span, frame.width)
    context.save()
    context.globalAlpha = modeOpacity(scene.palette.isDark)
    for (i in 0 until bands.size) {
        context.fillStyle = scene.palette[modeShade(bands.modeOf(i))]
        context.fillRect(frame.left + bands.leftOf(i), frame.top, bands.rightOf(i) - bands.leftOf(i), frame.height)
    }
    context.restore()
}

/** Shades the same, with the name of each mode where there is room. */
internal fun drawNamedModes(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span) {
    drawModes(context, frame, scene, span)
    if (scene.modes.spans.isEmpty()) return
    val ratio = window.devicePixelRatio
    context.save()
    context.font = "${LETTERS * ratio}px system-ui, sans-serif"
    context.asDynamic().textBaseline = "middle"
    context.fillStyle = scene.palette[Shade.MUTED]
    for (i in 0 until bands.size) {
        val name = bands.modeOf(i).title
        val room = bands.rightOf(i) - bands.leftOf(i) - 2 * MARGIN * ratio
        if (context.measureText(name).width <= room) {
            context.fillText(name, frame.left + bands.leftOf(i) + MARGIN * ratio, frame.top + frame.height / 2)
        }
    }
    context.restore()
}

/** Shared by all plots, which are drawn one after another. */
private val bands by lazy { ModeBands() }

private const val LETTERS = 11.0
private const val MARGIN = 5.0
