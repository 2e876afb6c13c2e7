package badlog.page.graph

import badlog.page.dom.add
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.text.word
import org.w3c.dom.HTMLElement

/** The cursors over one plot: their lines, a dot on each curve, and the event and finding under the cursor. */
internal class CursorOverlay(
    colors: List<Int>,
    private val scene: Scene,
    private val content: GraphContent,
    private val plot: PlotCanvas,
) {
    private val line = plot.over.add("div", "cursor-line")
    private val second = plot.over.add("div", "cursor-line is-second")
    private val pointer = plot.over.add("div", "cursor-line is-pointer")
    private val eventLabel = plot.over.add("div", "event-label")
    private val findingLabel = plot.over.add("div", "finding-label")
    private val dots = colors.map { plot.over.add("div", "cursor-dot line-${it % LINE_COLORS}") }

    /** Moves all elements to the current places of the cursors. */
    fun update() {
        val cursors = scene.cursor.now
        val frame = plot.frameOver
        line.classList.toggle("is-pinned", cursors.isPinned)
        line.classList.toggle("is-first", cursors.second != null)
        placeLine(line, cursors.x, frame)
        placeLine(second, cursors.second, frame)
        placeLine(pointer, cursors.hover.takeIf { cursors.isPinned }, frame)
        val x = scene.cursor.x
        dots.forEachIndexed { index, dot ->
            val place = if (x in frame.shown) content.dotAt(index, x, frame) else null
            dot.isHidden = place == null
            place?.let { (left, top) -> dot.style.transform = "translate(${left}px, ${top}px)" }
        }
        label(cursors.pointed ?: Double.NaN, frame)
    }

    private fun placeLine(line: HTMLElement, x: Double?, frame: PlotFrame) {
        val seen = x?.takeIf { it in frame.shown }
        line.isHidden = seen == null
        if (seen != null) line.style.transform = "translateX(${frame.x.placeOf(seen)}px)"
    }

    private fun label(x: Double, frame: PlotFrame) {
        val pointed = if (x in frame.shown) scene.pointedAt(x) else null
        eventLabel.isHidden = pointed?.said == null
        findingLabel.isHidden = pointed?.severity == null
        val pixel = frame.x.placeOf(x)
        pointed?.said?.let { show(eventLabel, it, pixel, frame.width) }
        val severity = pointed?.severity ?: return
        findingLabel.className = "finding-label is-${severity.word}"
        show(findingLabel, pointed.found, pixel, frame.width)
    }

    private fun show(label: HTMLElement, text: String, pixel: Double, width: Double) {
        label.showText(text)
        label.classList.toggle("at-left", pixel > width / 2)
        label.style.transform =
            if (pixel > width / 2) "translateX(calc(${pixel - GAP}px - 100%))" else "translateX(${pixel + GAP}px)"
    }

    private companion object {
        const val GAP = 7
    }
}
