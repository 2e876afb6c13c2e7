package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.PixelColumns
import badlog.page.export.Sheet
import badlog.page.view.Scene
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.Shade
import badlog.viewer.shown.cursor.dotAt
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement
import org.w3c.dom.asList
import kotlin.math.PI

/** Writes the title of [graph], and what its [legend] currently says about the drawn lines. */
internal fun drawGraphHead(sheet: Sheet, graph: Graph, legend: HTMLElement, scene: Scene) {
    sheet.line(HEADING)
    val unit = graph.titleUnit
    sheet.text(graph.title + if (unit.isEmpty()) "" else " ($unit)", TITLE, scene.palette[Shade.TEXT], isBold = true)
    sheet.line(LINE)
    for (entry in legend.querySelectorAll("[aria-pressed=true]").asList().map { it.unsafeCast<Element>() }) {
        val said = listOf(".legend-name", ".value", ".unit").mapNotNull {
            entry.querySelector(it)?.textContent?.ifEmpty { null }
        }.joinToString(" ")
        if (sheet.left + sheet.widthOf(said, LETTERS) + 2 * LETTERS > sheet.width) sheet.line(LINE)
        val color = (0 until LINE_COLORS).firstOrNull { entry.querySelector(".line-$it") != null }
        if (color != null && !graph.showsStates) sheet.swatch(scene.palette.line(color))
        sheet.text(said, LETTERS)
    }
    sheet.top += GAP
}

/** Draws [content] of [graph] with the cursors upon it, and the title of x below. */
internal fun drawGraphPlot(sheet: Sheet, graph: Graph, content: PlotContent, scene: Scene) {
    val now = scene.range.now
    val frame = plotFrame(sheet.width, content.height).showing(now)
    val columns = PixelColumns(frame.width.toInt())
    content.prepare(now, columns)
    sheet.part(content.height) {
        val context = sheet.context
        drawPlot(context, frame, scene, content)
        val cursors = scene.cursor.now
        context.strokeStyle = scene.palette[Shade.ACCENT]
        context.lineWidth = sheet.ratio
        for (x in listOfNotNull(cursors.x, cursors.second).filter { it in now }) {
            context.beginPath()
            context.moveTo(frame.x.placeOf(x), frame.top)
            context.lineTo(frame.x.placeOf(x), frame.bottom)
            context.stroke()
        }
        val x = cursors.x ?: return@part
        graph.series.forEachIndexed { index, series ->
            val share = content.heightAt(index, x)
            val at = series.dotAt(x)
            if (share !in 0.0..1.0 || at !in now || x !in now) return@forEachIndexed
            context.fillStyle = scene.palette.line(index)
            context.beginPath()
            context.arc(frame.x.placeOf(at), frame.top + share * frame.height, DOT * sheet.ratio, 0.0, 2 * PI)
            context.fill()
        }
    }
    val room = sheet.widthOf(scene.xAxis.title, LETTERS) + 2 * LETTERS
    sheet.left = maxOf(0.0, sheet.width - room)
    sheet.top += LETTERS / 2
    sheet.text(scene.xAxis.title, LETTERS)
}

private const val HEADING = 24
private const val TITLE = 13
private const val LINE = 17
private const val LETTERS = 12
private const val GAP = 6
private const val DOT = 3.5
