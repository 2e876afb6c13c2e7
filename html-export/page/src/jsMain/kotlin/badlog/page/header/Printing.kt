package badlog.page.header

import badlog.page.dom.PageEvents
import badlog.page.dom.element
import badlog.page.export.figureNotes
import badlog.page.export.svgOf
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.viewer.draw.figure.Sheet
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.Element
import org.w3c.dom.HTMLElement

/**
 * Prints the page in light colors, findings and the graphs of the board first. The graphs are redrawn for the width of the paper and never
 * split between two pages. The other graphs follow on request, or if neither board nor evidence has graphs.
 *
 * @param first returns the graphs of board and evidence.
 * @param others returns the graphs of the folders.
 * @param onPrint called before and after printing, with whether the page is laid out for paper.
 */
internal class Printing(
    private val scene: Scene,
    private val first: () -> List<GraphCard>,
    private val others: () -> List<GraphCard>,
    private val onPrint: (Boolean) -> Unit,
) {
    private val drawings = ArrayList<Element>()
    private var isWhole = false
    private var wasDark = false

    /** The text that names the printed part of the log. */
    val element: HTMLElement = element("p", "paper unit")

    init {
        PageEvents.on(window, "beforeprint") { begin() }
        PageEvents.on(window, "afterprint") { end() }
    }

    /** Opens the browser's print dialog, for all graphs if [isWhole]. */
    fun open(isWhole: Boolean) {
        this.isWhole = isWhole
        window.print()
    }

    private fun begin() {
        end()
        wasDark = scene.palette.isDark
        scene.palette.isDark = false
        scene.palette.apply()
        val whole = isWhole || first().isEmpty()
        document.documentElement?.setAttribute("data-print", if (whole) "all" else "board")
        element.textContent = scene.figureNotes.place
        for (card in first() + if (whole) others() else emptyList()) {
            val parsed = js("new DOMParser()").parseFromString(svgOf(Sheet.PAPER, card::drawOn), "image/svg+xml")
            val drawing = document.importNode(parsed.documentElement.unsafeCast<Element>(), true).unsafeCast<Element>()
            drawing.setAttribute("class", "paper")
            card.element.appendChild(drawing)
            drawings += drawing
        }
        onPrint(true)
    }

    private fun end() {
        if (document.documentElement?.hasAttribute("data-print") != true) return
        document.documentElement?.removeAttribute("data-print")
        for (drawing in drawings) drawing.remove()
        drawings.clear()
        scene.palette.isDark = wasDark
        scene.palette.apply()
        isWhole = false
        onPrint(false)
    }
}
