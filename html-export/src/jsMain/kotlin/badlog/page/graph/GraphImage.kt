package badlog.page.graph

import badlog.analysis.Graph
import badlog.page.dom.saveFile
import badlog.page.view.Scene
import badlog.plot.color.Shade
import badlog.plot.text.unitText
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.files.Blob

/** Saves [picture] as a PNG, with the graph's title and legend above it. */
internal fun saveGraphImage(graph: Graph, scene: Scene, isShown: BooleanArray, picture: HTMLCanvasElement) {
    val ratio = window.devicePixelRatio
    val canvas = document.createElement("canvas").unsafeCast<HTMLCanvasElement>()
    canvas.width = picture.width
    canvas.height = picture.height + (HEAD * ratio).toInt()
    val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
    context.fillStyle = scene.palette[Shade.SURFACE]
    context.fillRect(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble())
    context.save()
    context.scale(ratio, ratio)
    val unit = unitText(graph.unit)
    context.font = "600 15px system-ui, sans-serif"
    context.fillStyle = scene.palette[Shade.TEXT]
    context.fillText(graph.name + if (unit.isEmpty()) "" else " ($unit)", MARGIN, TITLE_LINE)
    context.font = "12px system-ui, sans-serif"
    var x = MARGIN
    val names = legendNames(graph)
    names.forEachIndexed { index, name ->
        if (!isShown[index] || graph.showsStates) return@forEachIndexed
        context.fillStyle = scene.palette.line(index)
        context.fillRect(x, LEGEND_LINE - SWATCH, SWATCH, SWATCH)
        context.fillStyle = scene.palette[Shade.MUTED]
        context.fillText(name, x + SWATCH + 4, LEGEND_LINE)
        x += SWATCH + 4 + context.measureText(name).width + MARGIN
    }
    context.restore()
    context.drawImage(picture, 0.0, HEAD * ratio)
    canvas.toBlob({ blob: Blob? -> if (blob != null) saveFile(blob, fileNameOf(graph.name)) })
}

// Slashes make folders, and some systems allow none of the others in a name.
private fun fileNameOf(name: String): String =
    name.map { if (it < ' ' || it in "\\/:*?\"<>|") '_' else it }.joinToString("").take(MAX_NAME_LENGTH).trim() + ".png"

private const val HEAD = 50
private const val MARGIN = 12.0
private const val TITLE_LINE = 22.0
private const val LEGEND_LINE = 42.0
private const val SWATCH = 10.0
private const val MAX_NAME_LENGTH = 120
