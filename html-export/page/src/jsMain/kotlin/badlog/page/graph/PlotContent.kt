package badlog.page.graph

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.draw.axis.GraphAxis
import org.w3c.dom.CanvasRenderingContext2D

/** What a plot shows inside its frame: lines, or lanes of states. */
internal interface PlotContent {
    /** The height of the plot with its axis, in CSS pixels. */
    val height: Int

    /** Whether it would cover the shading of the modes. */
    val isOpaque: Boolean

    /** The y axes, the left one first; none if y means nothing. Set by [prepare], like [limits]. */
    val axes: List<GraphAxis>

    /** The part of y that each of [axes] shows. */
    val limits: List<Span>

    /** Finds out what is visible of [span] on a screen with as many pixel columns as [columns] has. */
    fun prepare(span: Span, columns: PixelColumns)

    /** Draws what [prepare] found. */
    fun draw(context: CanvasRenderingContext2D, frame: PlotFrame)

    /**
     * Returns where on y the sample of series [index] nearest to [x] is, as a fraction of the frame's height from
     * the top; NaN for none.
     */
    fun heightAt(index: Int, x: Double): Double
}
