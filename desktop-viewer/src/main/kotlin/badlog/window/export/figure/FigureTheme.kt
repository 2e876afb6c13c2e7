package badlog.window.export.figure

import badlog.window.theme.Palette
import org.jetbrains.letsPlot.intern.OptionsMap
import org.jetbrains.letsPlot.themes.elementBlank
import org.jetbrains.letsPlot.themes.elementLine
import org.jetbrains.letsPlot.themes.elementRect
import org.jetbrains.letsPlot.themes.elementText
import org.jetbrains.letsPlot.themes.theme

/** Returns the theme of a frame of [size]: the first has the figure's title, the last the texts of the x axis. */
internal fun figureTheme(size: FrameSize, hasLanes: Boolean): OptionsMap {
    val text = hexOf(Palette.LIGHT.text)
    val muted = hexOf(Palette.LIGHT.muted)
    val grid = elementLine(color = hexOf(Palette.LIGHT.border), size = 0.5)
    return theme(
        text = elementText(color = text, size = 12),
        plotTitle = elementText(color = text, size = if (size.isFirst) 17 else 13, face = "bold"),
        plotSubtitle = elementText(color = text, size = 13, face = "bold"),
        axisTitle = elementText(color = muted, size = 12),
        axisText = elementText(color = muted, size = 11),
        axisTextX = if (size.isLast) elementText(color = muted, size = 11) else elementBlank(),
        axisTicksX = if (size.isLast) elementLine(color = muted, size = 0.7) else elementBlank(),
        axisTicksY = elementBlank(),
        axisLine = elementBlank(),
        axisTooltip = elementBlank(),
        legendText = elementText(color = text, size = 12),
        legendTitle = elementBlank(),
        panelBackground = elementRect(fill = "white", size = 0),
        panelBorder = elementRect(color = hexOf(Palette.LIGHT.muted), size = 0.7),
        panelGridMajorX = grid,
        panelGridMajorY = if (hasLanes) elementBlank() else grid,
        panelGridMinor = elementBlank(),
        plotBackground = elementRect(fill = "white", size = 0),
    ).legendPositionTop().legendJustification(0.0, 1.0)
}

/**
 * The size of one frame of a figure, with its texts, in points of SVG.
 *
 * @property isFirst whether the figure's title is above it.
 * @property isLast whether its x axis is below it.
 * @property legendRows the number of rows of its legend; 0 if the title, or the legend of a frame above, is enough.
 * @property plotWidth the approximate width of the part with the lines.
 * @property height the total height.
 */
internal class FrameSize(val isFirst: Boolean, val isLast: Boolean, val legendRows: Int, val plotWidth: Int, val height: Int) {
    companion object {
        /** Returns the size of frame [index] of [figure]. */
        fun of(figure: Figure, index: Int, options: FigureOptions): FrameSize {
            val frame = figure.frames[index]
            val isFirst = index == 0
            val isLast = frame.plane != null || index == figure.frames.indexOfLast { it.plane == null }
            val plotWidth = maxOf(options.width - SIDES, MIN_SIDE)
            val isTold = figure.frames.take(index).any { it.legend == frame.legend }
            val rows = if (isTold) 0 else legendRows(frame, plotWidth)
            val lanes = maxOf(frame.lanes.size * LANE, MIN_LANES) + BELOW_LANES
            val plot = when {
                frame.plane != null -> plotWidth / 2
                frame.lanes.isEmpty() -> maxOf(options.graphHeight, MIN_SIDE)
                else -> lanes
            }
            val legend = if (rows > 0) LEGEND + rows * LEGEND_ROW else 0
            val atEnds = (if (isFirst) TITLE else 0) + (if (isLast) X_AXIS else 0)
            return FrameSize(isFirst, isLast, rows, plotWidth, plot + SUBTITLE + legend + atEnds)
        }

        private fun legendRows(frame: FigureFrame, width: Int): Int {
            if (!frame.hasLegend || frame.lines.isEmpty()) return 0
            val longest = frame.lines.maxOf { it.label.length }
            val perRow = maxOf(width / (longest * LETTER + KEY), 1)
            return (frame.lines.size + perRow - 1) / perRow
        }

        private const val MIN_SIDE = 60

        /** Lets-plot does not draw in less. */
        private const val MIN_LANES = 52
        private const val SIDES = 110
        private const val LANE = 26
        private const val SUBTITLE = 34
        private const val LEGEND = 18
        private const val LEGEND_ROW = 19
        private const val TITLE = 32
        private const val X_AXIS = 28
        private const val BELOW_LANES = 12
        private const val LETTER = 7
        private const val KEY = 34
    }
}
