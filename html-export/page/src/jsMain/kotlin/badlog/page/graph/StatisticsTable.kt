package badlog.page.graph

import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Span
import badlog.core.analysis.statistics
import badlog.page.dom.Icon
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.pen.CanvasPen
import badlog.page.view.Scene
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.plot.HISTOGRAM_HEIGHT
import badlog.viewer.draw.plot.drawHistogram
import badlog.viewer.shown.comparison.ComparedGraph
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.statistics.ChannelOrder
import badlog.viewer.shown.statistics.Histogram
import badlog.viewer.shown.statistics.NamedDifference
import badlog.viewer.shown.statistics.StateTime
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.shown.statistics.textOf
import badlog.viewer.shown.statistics.timesOf
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import badlog.viewer.text.shortNames
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement

/** The statistics of each line of a graph, between the cursors A and B or otherwise over the visible range. */
internal class StatisticsTable(compared: ComparedGraph, private val scene: Scene) {
    private val graph = compared.graph
    private val colors = compared.colors
    private val names = shortNames(compared.names)
    val element: HTMLElement = element("div", "statistics")

    private val runs by lazy { graph.series.map { it.stateRuns() } }
    private var shown: Span? = null
    private var order = ChannelOrder.CHARGE

    /** The index of the line with the open histogram; -1 for none. */
    private var opened = -1
    private var histogram: Histogram? = null
    private var canvas: HTMLCanvasElement? = null

    /** The place of the histogram, and its content. */
    private var place: HTMLElement = element("div")
    private var statistics = emptyList<SeriesStatistics>()
    private var buttons = emptyList<HTMLElement>()

    init {
        ResizeObserver(::repaint).observe(element)
    }

    private val wanted get() = scene.cursor.now.between ?: scene.range.now

    /** Whether the statistics are about an earlier range. */
    val isOutdated: Boolean get() = shown != wanted

    /** Calculates the current statistics. */
    fun update() {
        val now = wanted
        shown = now
        // The keyboard stays on the button of a line.
        val focused = buttons.indexOfFirst { it == document.activeElement }
        element.textContent = ""
        statistics = if (graph.showsStates) emptyList() else graph.series.map { it.statistics(now.from, now.to) }
        buttons = emptyList()
        element.add("table") {
            val name = if (scene.cursor.now.between == null) "" else "${Cursors.BETWEEN}: "
            val how = if (graph.showsStates) "" else " ${Statistic.BY_TIME}"
            add("caption", "", "$name${scene.xNumber(now.from)} – ${scene.xText(now.to)}.$how")
            if (graph.showsStates) return@add addStates(now)
            add("thead").add("tr") {
                add("th", "", "Line")
                for (statistic in Statistic.entries) add("th", "", statistic.title).title = statistic.hint
            }
            add("tbody") {
                statistics.forEachIndexed { index, found ->
                    add("tr") {
                        add("th") {
                            setAttribute("scope", "row")
                            add("span", "swatch line-${colors[index] % LINE_COLORS}")
                            addName(names[index])
                            addHistogramButton(index, names[index])
                        }
                        for (statistic in Statistic.entries) {
                            val value = statistic.of(found)
                            add("td", "", statistic.textOf(value)).title = exactText(value)
                        }
                    }
                }
            }
        }
        buttons.getOrNull(focused)?.focus()
        place = element.add("div")
        showHistogram()
        addDifferences(now)
        if (graph.series.any { it.topic.name in scene.channels.topics }) addChannels(now)
    }

    private fun HTMLElement.addHistogramButton(index: Int, name: String) {
        buttons += addIconButton("", Icon.BARS, "Histogram of $name: ${Histogram.HINT}") {
            opened = if (opened == index) -1 else index
            showHistogram()
        }
    }

    /** Shows the histogram of the line with the pressed button, over the range of the statistics. */
    private fun showHistogram() {
        buttons.forEachIndexed { index, button -> button.setAttribute("aria-pressed", (opened == index).toString()) }
        place.textContent = ""
        histogram = null
        val range = shown ?: return
        val line = graph.series.getOrNull(opened) ?: return
        val known = statistics.getOrNull(opened) ?: return
        val found = Histogram.of(line, listOf(range), known)
        if (found == null) {
            place.add("p", "cursor-panel-hint", Histogram.NONE)
            return
        }
        histogram = found
        canvas = place.add("canvas", "histogram").unsafeCast<HTMLCanvasElement>().apply {
            setAttribute("role", "img")
            setAttribute("aria-label", "Histogram of ${names[opened]}")
        }
        repaint()
    }

    /** Redraws the histogram, if there is one, in the current colors. */
    fun repaint() {
        val found = histogram ?: return
        val canvas = canvas ?: return
        val ratio = window.devicePixelRatio
        canvas.style.height = "${HISTOGRAM_HEIGHT}px"
        canvas.width = (canvas.clientWidth * ratio).toInt()
        canvas.height = (HISTOGRAM_HEIGHT * ratio).toInt()
        val pen = CanvasPen(canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>())
        pen.drawHistogram(found, graph.series[opened].unit, colors[opened], canvas.width.toDouble(), scene.palette.colors)
    }

    /** Adds what each channel gave; a click on a title sorts. */
    private fun addChannels(now: Span) = element.add("table", "channels") {
        add("thead").add("tr") {
            add("th", "", scene.channels.what)
            for (by in ChannelOrder.entries) {
                val title = add("th")
                if (by == order) title.setAttribute("aria-sort", "descending")
                val button = title.addButton("text-button", by.title + if (by == order) " ↓" else "", by.hint) {
                    order = by
                    update()
                    document.getElementById(idOf(by))?.asDynamic()?.focus()
                }
                button.id = idOf(by)
            }
            add("th", "", "Share")
        }
        add("tbody") {
            for (channel in scene.channels.ranked(listOf(now), order)) {
                add("tr") {
                    add("th") { addName(channel.name) }.setAttribute("scope", "row")
                    for (text in listOf(channel.chargeText, channel.peakText, channel.shareText)) add("td", "", text)
                }
            }
        }
    }

    /** Adds how the lines after the first differ from it. */
    private fun addDifferences(now: Span) {
        val differences = NamedDifference.of(graph.series, listOf(now))
        if (differences.isEmpty()) return
        val names = graph.series.zip(names).toMap()
        element.add("table", "differences") {
            add("thead").add("tr") {
                add("th", "", "Difference")
                NamedDifference.TITLES.forEachIndexed { i, title -> add("th", "", title).title = NamedDifference.HINTS[i] }
            }
            add("tbody") {
                for (difference in differences) {
                    add("tr") {
                        add("th") {
                            setAttribute("scope", "row")
                            addName(names.getValue(difference.one))
                            add("span", "", " − ")
                            addName(names.getValue(difference.other))
                        }
                        val exact = difference.exactTexts()
                        difference.texts(scene.xAxis).forEachIndexed { i, text -> add("td", "", text).title = exact[i] }
                    }
                }
            }
        }
    }

    private fun idOf(order: ChannelOrder) = "channels-${graph.name}-${order.name}"

    /** Returns how long lane [index] was in each state over the current range, as lines of text. */
    fun hintOf(index: Int): String = runs[index].textOf(graph.series[index].states.orEmpty(), wanted, scene.xAxis)

    /** Adds how long and how often each lane was in each state. */
    private fun HTMLElement.addStates(now: Span) {
        add("thead").add("tr") { for (title in StateTime.TITLES) add("th", "", title) }
        add("tbody") {
            graph.series.forEachIndexed { index, series ->
                runs[index].timesOf(series.states.orEmpty(), listOf(now)).take(StateTime.MAX_LISTED).forEachIndexed { place, time ->
                    add("tr") {
                        add("th") { if (place == 0) addName(names[index]) }.setAttribute("scope", "row")
                        val cells = listOf(time.state, time.timeText(scene.xAxis), time.shareText, countText(time.count))
                        for (cell in cells) add("td", "", cell)
                    }
                }
            }
        }
    }
}
