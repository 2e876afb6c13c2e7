package badlog.page.graph

import badlog.core.analysis.PixelColumns
import badlog.page.view.Scene
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.xTitle
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.draw.plot.drawSample
import badlog.viewer.shown.cursor.dotAt

/** Draws [content] of [lines] with the cursors upon it, and the title of x below. */
internal fun drawGraphPlot(sheet: Sheet, lines: CardLines, content: PlotContent, scene: Scene) {
    val now = scene.range.now
    val colors = PenColors.LIGHT
    sheet.part(content.height.toDouble()) { pen ->
        val frame = PlotMargins.frameOf(sheet.width, content.height, now, pen.density)
        val plot = content.plotIn(frame, PixelColumns(frame.width.toInt()), pen.density)
        pen.drawPlot(frame, plot, scene.marks, colors, PlotMargins.BOTTOM * pen.density)
        // The pointer's accidental place does not belong in a figure.
        pen.drawCursors(frame, scene.cursor.now.copy(hover = null), colors)
        val x = scene.cursor.now.pinned ?: return@part
        lines.graph.series.forEachIndexed { index, series ->
            val share = content.heightAt(index, x)
            val at = series.dotAt(x)
            if (share !in 0.0..1.0 || at !in now || x !in now) return@forEachIndexed
            pen.drawSample(frame.x.placeOf(at), frame.top + share * frame.height, lines.colors[index], colors)
        }
    }
    sheet.xTitle(scene.xAxis.title)
}
