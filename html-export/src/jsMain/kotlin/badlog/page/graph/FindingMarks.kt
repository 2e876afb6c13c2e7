package badlog.page.graph

import badlog.analysis.Span
import badlog.page.view.Scene
import badlog.plot.color.Shade
import badlog.recording.Severity
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.Path2D
import kotlin.math.PI

/**
 * Draws the marks of the findings of [span] at the foot of a plot, where no event has its: a diamond for an error, a triangle for
 * a warning, a ring for a note, below a dashed line; a band over what lasts.
 */
internal fun drawFindingMarks(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, span: Span = scene.range.now) {
    if (scene.findings.places.isEmpty()) return
    context.save()
    context.beginPath()
    context.rect(frame.left, frame.top, frame.width, frame.height)
    context.clip()
    // The worst last, over the others.
    for (severity in Severity.entries) FindingPaths(frame, severity).apply { add(scene, span) }.draw(context, scene)
    context.restore()
}

/** The marks of one severity, gathered so that what overlaps is not drawn twice. */
private class FindingPaths(private val frame: PlotFrame, private val severity: Severity) {
    private val ratio = window.devicePixelRatio
    private val bands = Path2D()
    private val feet = Path2D()
    private val lines = Path2D()
    private val heads = Path2D()
    private val taken = HashSet<Int>()
    private var lastLine = Double.NEGATIVE_INFINITY

    fun add(scene: Scene, span: Span) {
        for (place in scene.findings.places) {
            val from = place.span.from
            val to = place.span.to
            if (from > span.to) break
            if (place.finding.severity != severity || to < span.from) continue
            val pixel = frame.x.placeOf(from)
            if (to > from) addBand(maxOf(pixel, frame.left), minOf(frame.x.placeOf(to), frame.right))
            if (from >= span.from && taken.add((pixel / ratio).toInt())) addMark(pixel)
        }
    }

    private fun addBand(left: Double, right: Double) {
        val width = maxOf(right - left, ratio)
        bands.rect(left, frame.top, width, frame.height)
        feet.rect(left, frame.bottom - FOOT * ratio, width, FOOT * ratio)
    }

    private fun addMark(pixel: Double) {
        // A crowd of lines would hide the graph; their heads tell enough.
        if (pixel - lastLine >= APART * ratio) {
            lines.moveTo(pixel, frame.top)
            lines.lineTo(pixel, frame.bottom)
            lastLine = pixel
        }
        val size = HEAD * ratio
        val middle = frame.bottom - size - ratio
        when (severity) {
            Severity.ERROR -> {
                heads.moveTo(pixel, middle - size)
                heads.lineTo(pixel + size, middle)
                heads.lineTo(pixel, middle + size)
                heads.lineTo(pixel - size, middle)
            }

            Severity.WARNING -> {
                heads.moveTo(pixel, middle - size)
                heads.lineTo(pixel + size, middle + size)
                heads.lineTo(pixel - size, middle + size)
            }

            Severity.NOTE -> {
                heads.moveTo(pixel + size - ratio, middle)
                heads.arc(pixel, middle, size - ratio, 0.0, 2 * PI)
            }
        }
        heads.closePath()
    }

    fun draw(context: CanvasRenderingContext2D, scene: Scene) {
        val colour = scene.palette.severity(severity)
        context.fillStyle = colour
        context.strokeStyle = colour
        context.lineWidth = ratio
        context.globalAlpha = BAND_OPACITY
        context.fill(bands)
        context.globalAlpha = LINE_OPACITY
        context.setLineDash(arrayOf(DASH * ratio, DASH * ratio))
        context.stroke(lines)
        context.setLineDash(emptyArray())
        context.globalAlpha = 1.0
        context.fill(feet)
        if (severity == Severity.NOTE) {
            context.fillStyle = scene.palette[Shade.SURFACE]
            context.lineWidth = RING * ratio
        }
        context.fill(heads)
        context.stroke(heads)
    }

    private companion object {
        const val HEAD = 4.5
        const val FOOT = 3.0
        const val DASH = 3.0
        const val APART = 9
        const val RING = 1.8
        const val BAND_OPACITY = 0.13
        const val LINE_OPACITY = 0.6
    }
}
