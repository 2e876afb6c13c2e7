package badlog.page.graph

import badlog.analysis.Graph
import badlog.page.dom.add
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.page.view.findingText
import badlog.page.view.word
import badlog.plot.color.LINE_COLORS
import badlog.plot.cursor.dotAt
import org.w3c.dom.HTMLElement

/** The cursor over one plot: its line, a dot on each curve, and the event and the finding it points at. */
internal class CursorOverlay(
    private val graph: Graph,
    private val scene: Scene,
    private val content: PlotContent,
    private val plot: Plot,
) {
    private val line = plot.over.add("div", "cursor-line")
    private val eventLabel = plot.over.add("div", "event-label")
    private val findingLabel = plot.over.add("div", "finding-label")
    private val dots = graph.series.indices.map { plot.over.add("div", "cursor-dot line-${it % LINE_COLORS}") }

    init {
        update()
    }

    /** Puts everything where the cursor is now. */
    fun update() {
        val now = scene.range.now
        val x = scene.cursor.x
        val isSeen = scene.cursor.isPlaced && x >= now.from && x <= now.to
        line.isHidden = !isSeen
        val said = if (isSeen) scene.noteAt(x)?.text ?: scene.eventAt(x)?.text else null
        val findings = if (isSeen) scene.findingsAt(x) else emptyList()
        eventLabel.isHidden = said == null
        findingLabel.isHidden = findings.isEmpty()
        if (!isSeen) {
            for (dot in dots) dot.isHidden = true
            return
        }
        val width = plot.frameWidth
        val pixel = (x - now.from) / now.width * width
        line.style.transform = "translateX(${pixel}px)"
        dots.forEachIndexed { index, dot -> place(dot, index, x, width) }
        if (said != null) show(eventLabel, said, pixel, width)
        if (findings.isEmpty()) return
        findingLabel.className = "finding-label is-${findings[0].word}"
        show(findingLabel, findingText(findings, x), pixel, width)
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
