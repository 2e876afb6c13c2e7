package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.page.dom.add
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.page.view.word
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.shown.cursor.dotAt
import org.w3c.dom.HTMLElement

/** The cursors over one plot: their lines, a dot on each curve where values are read, and the event and finding under the cursor. */
internal class CursorOverlay(
    private val graph: Graph,
    colors: List<Int>,
    private val scene: Scene,
    private val content: PlotContent,
    private val plot: PlotCanvas,
) {
    private val line = plot.over.add("div", "cursor-line")
    private val second = plot.over.add("div", "cursor-line is-second")
    private val pointer = plot.over.add("div", "cursor-line is-pointer")
    private val eventLabel = plot.over.add("div", "event-label")
    private val findingLabel = plot.over.add("div", "finding-label")
    private val dots = colors.map { plot.over.add("div", "cursor-dot line-${it % LINE_COLORS}") }

    /** Moves everything to where the cursors are now. */
    fun update() {
        val cursors = scene.cursor.now
        val width = plot.frameWidth
        line.classList.toggle("is-pinned", cursors.isPinned)
        line.classList.toggle("is-first", cursors.second != null)
        placeLine(line, cursors.x, width)
        placeLine(second, cursors.second, width)
        placeLine(pointer, cursors.hover.takeIf { cursors.isPinned }, width)
        val x = scene.cursor.x
        dots.forEachIndexed { index, dot -> if (isSeen(x)) place(dot, index, x, width) else dot.isHidden = true }
        label(cursors.pointed ?: Double.NaN, width)
    }

    private fun isSeen(x: Double) = x in scene.range.now

    private fun pixelOf(x: Double, width: Double) = (x - scene.range.now.from) / scene.range.now.width * width

    private fun placeLine(line: HTMLElement, x: Double?, width: Double) {
        val seen = x?.takeIf(::isSeen)
        line.isHidden = seen == null
        if (seen != null) line.style.transform = "translateX(${pixelOf(seen, width)}px)"
    }

    private fun label(x: Double, width: Double) {
        val pointed = if (isSeen(x)) scene.pointedAt(x) else null
        eventLabel.isHidden = pointed?.said == null
        findingLabel.isHidden = pointed?.severity == null
        val pixel = pixelOf(x, width)
        pointed?.said?.let { show(eventLabel, it, pixel, width) }
        val severity = pointed?.severity ?: return
        findingLabel.className = "finding-label is-${severity.word}"
        show(findingLabel, pointed.found, pixel, width)
    }

    private fun show(label: HTMLElement, text: String, pixel: Double, width: Double) {
        label.showText(text)
        label.classList.toggle("at-left", pixel > width / 2)
        label.style.transform =
            if (pixel > width / 2) "translateX(calc(${pixel - GAP}px - 100%))" else "translateX(${pixel + GAP}px)"
    }

    private fun place(dot: HTMLElement, index: Int, x: Double, width: Double) {
        val now = scene.range.now
        val share = content.heightAt(index, x)
        val sampleX = (graph.series[index].dotAt(x) - now.from) / now.width
        dot.isHidden = !(share in 0.0..1.0 && sampleX in 0.0..1.0)
        if (!dot.isHidden) dot.style.transform = "translate(${sampleX * width}px, ${share * plot.frameHeight}px)"
    }

    private companion object {
        const val GAP = 7
    }
}
