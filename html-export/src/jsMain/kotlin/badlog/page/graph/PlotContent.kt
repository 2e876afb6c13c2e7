package badlog.page.graph

import badlog.analysis.PixelColumns
import badlog.analysis.Span
import badlog.plot.axis.GraphAxis
import org.w3c.dom.CanvasRenderingContext2D

/** What a plot shows inside its frame: lines, or lanes of states. */
internal interface PlotContent {
    /** How tall the plot is with its axis, in CSS pixels. */
    val height: Int

    /** Whether it would hide the shading of the modes. */
    val isOpaque: Boolean

    /** The axes of y, the one at the left first, none where y means nothing; settled by [prepare], as [limits] are. */
    val axes: List<GraphAxis>

    /** The part of y that each of [axes] shows. */
    val limits: List<Span>

    /** Finds what is to be seen of [span] on a screen of as many pixel columns as [columns] has. */
    fun prepare(span: Span, columns: PixelColumns)

    /** Draws what [prepare] found. */
    fun draw(context: CanvasRenderingContext2D, frame: PlotFrame)

    /**
     * Where on y the sample of series [index] nearest to [x] stands, as a share of the frame from its top; NaN for
     * none.
     */
    fun heightAt(index: Int, x: Double): Double
}
