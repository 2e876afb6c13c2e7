package badlog.viewer.takeaway.figure

import badlog.viewer.theme.Palette
import org.jetbrains.letsPlot.intern.OptionsMap
import org.jetbrains.letsPlot.themes.elementBlank
import org.jetbrains.letsPlot.themes.elementLine
import org.jetbrains.letsPlot.themes.elementRect
import org.jetbrains.letsPlot.themes.elementText
import org.jetbrains.letsPlot.themes.theme

/** How a frame of [size] looks: the first has the figure's title, the last the texts of the x axis. */
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
