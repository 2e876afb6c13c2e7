package badlog.charts.look

import badlog.charts.match.ChartedMatches
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.cssColor
import badlog.viewer.draw.color.lineColor
import org.jetbrains.letsPlot.ggsize
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.themes.elementBlank
import org.jetbrains.letsPlot.themes.elementLine
import org.jetbrains.letsPlot.themes.elementRect
import org.jetbrains.letsPlot.themes.elementText
import org.jetbrains.letsPlot.themes.margin
import org.jetbrains.letsPlot.themes.theme

/** The colors of charts, as in the light theme of page and window, which also suits paper. */
internal object ChartColors {
    val LINE = cssColor(lineColor(0, isDark = false))
    val TEXT = cssColor(Shade.TEXT.of(isDark = false))
    val MUTED = cssColor(Shade.MUTED.of(isDark = false))
    val GRID = cssColor(Shade.GRID.of(isDark = false))
    val BORDER = cssColor(Shade.BORDER.of(isDark = false))
    val BAND = cssColor(Shade.ACCENT_SOFT.of(isDark = false))
    val LIMIT = cssColor(Shade.ERROR.of(isDark = false))
    val SURFACE = cssColor(Shade.SURFACE.of(isDark = false))

    /** Returns the color of line [index], from 0. */
    fun line(index: Int) = cssColor(lineColor(index, isDark = false))
}

/**
 * The texts of a kind of chart.
 *
 * @property name its name in names of files.
 * @property title its title.
 * @property question the question that it answers.
 * @property x the label of the horizontal axis, with the unit; empty for the matches, which need none.
 * @property y the label of the vertical axis, with the unit.
 */
internal class ChartTexts(val name: String, val title: String, val question: String, val y: String, val x: String = "")

/**
 * Returns a chart of [matches] without marks: its texts, its size and the look that all charts share.
 *
 * @param shown the number of matches that it shows.
 * @param reading a sentence about how to read it.
 */
internal fun emptyPlot(texts: ChartTexts, matches: ChartedMatches, shown: Int, reading: String): Plot = letsPlot() +
    labs(
        title = listOf(texts.title, matches.event).filter { it.isNotEmpty() }.joinToString(" · "),
        subtitle = texts.question,
        x = texts.x,
        y = texts.y,
        caption = "${captionOf(shown, matches.others)} · $reading",
    ) +
    ggsize(Chart.WIDTH, Chart.HEIGHT) +
    theme(
        text = elementText(family = "sans-serif", color = ChartColors.TEXT, size = TEXT_SIZE),
        plotTitle = elementText(family = "sans-serif", face = "bold", size = TITLE_SIZE),
        plotSubtitle = elementText(color = ChartColors.MUTED, size = TEXT_SIZE),
        plotCaption = elementText(color = ChartColors.MUTED, size = SMALL_SIZE),
        axisText = elementText(color = ChartColors.MUTED, size = SMALL_SIZE),
        axisTitle = elementText(color = ChartColors.TEXT, size = SMALL_SIZE),
        axisLine = elementLine(color = ChartColors.BORDER),
        axisTicks = elementLine(color = ChartColors.BORDER),
        panelGridMajorX = elementBlank(),
        panelGridMajorY = elementLine(color = ChartColors.GRID),
        panelGridMinor = elementBlank(),
        plotBackground = elementRect(fill = ChartColors.SURFACE, color = ChartColors.SURFACE),
        panelBackground = elementRect(fill = ChartColors.SURFACE, color = ChartColors.SURFACE),
        plotMargin = margin(MARGIN, MARGIN, MARGIN, MARGIN),
        legendTitle = elementBlank(),
        legendText = elementText(size = SMALL_SIZE),
    )

private fun captionOf(shown: Int, others: Int): String = when {
    others == 0 -> if (shown == 1) "1 log" else "$shown logs"
    others == 1 -> "$shown matches, without 1 other log"
    else -> "$shown matches, without $others other logs"
}

private const val TITLE_SIZE = 20
private const val TEXT_SIZE = 16
private const val SMALL_SIZE = 14
private const val MARGIN = 12
