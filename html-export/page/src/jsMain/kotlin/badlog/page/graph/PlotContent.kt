package badlog.page.graph

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.draw.plot.Plot
import badlog.viewer.draw.plot.PlotFrame

/** What a plot shows inside its frame: lines, or lanes of states. */
internal interface PlotContent {
    /** The height of the plot with its axis, in CSS pixels. */
    val height: Int

    /** The part of y that each y axis showed last, the left one first; none if y means nothing. */
    val limits: List<Span>

    /**
     * Returns what is visible in [frame], whose pixels are [ratio] for each CSS pixel, with as many points as [columns] need. It is valid
     * until the next call.
     */
    fun plotIn(frame: PlotFrame, columns: PixelColumns, ratio: Double): Plot

    /**
     * Returns where on y the sample of series [index] nearest to [x] is, as a fraction of the frame's height from
     * the top; NaN for none.
     */
    fun heightAt(index: Int, x: Double): Double
}
