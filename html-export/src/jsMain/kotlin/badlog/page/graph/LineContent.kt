package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.PixelColumns
import badlog.analysis.Span
import badlog.page.dom.json
import badlog.page.view.Palette
import badlog.plot.axis.YLimits
import badlog.plot.cursor.indexAt
import badlog.plot.curve.Curve
import badlog.plot.curve.Strokes
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D

/**
 * Numbers as lines over x.
 *
 * @param isShown for each series whether its line is to be drawn; the legend changes it.
 * @param end until where the last value of a series holds, if its values do.
 * @param height how tall it is; null for as tall as others.
 */
internal class LineContent(
    private val graph: Graph,
    private val palette: Palette,
    private val isShown: BooleanArray,
    end: Double,
    height: Int?,
) : PlotContent {
    private val curves = graph.series.map { Curve(it.data, if (it.holds) end else null) }
    private val strokes = curves.map { Strokes() }

    override val height: Int = height ?: HEIGHT
    override val limits: YLimits = YLimits()
    override val hasYAxis: Boolean get() = true

    override fun lines(frameOf: (UPlot) -> PlotFrame): List<dynamic> = curves.mapIndexed { index, curve ->
        json(
            "scale" to "y",
            "auto" to false,
            "show" to isShown[index],
            "stroke" to { palette.line(index) },
            "fill" to { if (graph.isFilled) palette.line(index) + AREA_OPACITY else null },
            "paths" to { plot: UPlot ->
                val frame = frameOf(plot)
                strokes[index].trace(curve, frame.x, frame.y)
                strokesPath(strokes[index], frame, graph.isFilled)
            },
            "points" to json(
                "show" to { strokes[index].dotsSize > 0 },
                "width" to 0,
                "fill" to { palette.line(index) },
                "paths" to { plot: UPlot ->
                    val radius = if (curve.isSparse) DOT_RADIUS else LONE_RADIUS
                    dotsPath(strokes[index], frameOf(plot), radius * window.devicePixelRatio)
                },
            ),
        )
    }

    override fun prepare(span: Span, columns: PixelColumns) {
        var least = Double.NaN
        var most = Double.NaN
        curves.forEachIndexed { index, curve ->
            if (!isShown[index]) return@forEachIndexed
            curve.draw(span.from, span.to, columns)
            if (curve.min.isNaN()) return@forEachIndexed
            if (!(least <= curve.min)) least = curve.min
            if (!(most >= curve.max)) most = curve.max
        }
        limits.fit(least, most, graph.includesZero)
    }

    override fun style(plot: UPlot) {
        curves.forEachIndexed { index, curve ->
            val line = plot.series[index + 1]
            line.show = isShown[index]
            // Strokes of up to one pixel of the screen are many times as fast as wider ones.
            line.width = if (curve.isDense) 1 / window.devicePixelRatio else LINE_WIDTH
        }
    }

    override fun draw(context: CanvasRenderingContext2D, frame: PlotFrame) = Unit

    override fun heightAt(index: Int, x: Double): Double {
        val series = graph.series[index]
        val sample = series.indexAt(x)
        if (!isShown[index] || sample < 0) return Double.NaN
        return (limits.to - series.data.y[sample]) / (limits.to - limits.from)
    }

    private companion object {
        const val HEIGHT = 190
        const val LINE_WIDTH = 1.5
        const val DOT_RADIUS = 2.5
        const val LONE_RADIUS = 1.0
        const val AREA_OPACITY = "30"
    }
}
