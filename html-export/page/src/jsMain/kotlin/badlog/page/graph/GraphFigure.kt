package badlog.page.graph

import badlog.core.analysis.PixelColumns
import badlog.page.view.Scene
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.xTitle
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.draw.plot.drawSamples

/** Draws [content] with the cursors over it and the title of x below. */
internal fun drawGraphPlot(sheet: Sheet, content: GraphContent, scene: Scene) {
    val now = scene.range.now
    val colors = PenColors.LIGHT
    sheet.part(content.height.toDouble()) { pen ->
        val frame = PlotMargins.frameOf(sheet.width, content.height, now, pen.density)
        val plot = content.plotIn(frame, PixelColumns(frame.width.toInt()), pen.density)
        pen.drawPlot(frame, plot, scene.marks, colors, PlotMargins.BOTTOM * pen.density)
        // A figure must not show where the pointer happens to be.
        pen.drawCursors(frame, scene.cursor.now.withoutPointer, colors)
        scene.cursor.now.pinned?.let { pen.drawSamples(frame, plot, content.drawnLines, it, colors) }
    }
    sheet.xTitle(scene.xAxis.title)
}
