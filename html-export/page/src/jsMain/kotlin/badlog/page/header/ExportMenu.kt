package badlog.page.header

import badlog.page.dom.Icon
import badlog.page.dom.MenuEntry
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.openMenu
import badlog.page.export.imageEntries
import badlog.page.export.saveTable
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.viewer.shown.table.CsvDraft
import org.w3c.dom.HTMLElement

/**
 * The menu of exports: a copy of this page with its notes, print, pictures and tables.
 *
 * @param onCopy saves a copy of the page.
 * @param board returns the graphs of the board.
 */
internal class ExportMenu(
    private val scene: Scene,
    private val printing: Printing,
    private val onCopy: () -> Unit,
    private val board: () -> List<GraphCard>,
) {
    val element: HTMLElement = element("div", "export") {
        val button = addButton("", "", "Print, pictures and tables") {}
        button.id = "export"
        button.appendChild(Icon.DOWNLOAD.draw())
        button.add("span", "", "Export")
        button.setAttribute("aria-haspopup", "menu")
        button.setAttribute("aria-expanded", "false")
        button.addEventListener("click", { openMenu(button, button.closest(".page-head").unsafeCast<HTMLElement>(), entries()) })
    }

    private fun entries(): List<MenuEntry> {
        val shown = scene.range.now.takeIf { scene.range.isZoomed }
        val cards = board()
        return buildList {
            add(MenuEntry("A copy of this page, with your notes and board") { onCopy() })
            add(MenuEntry("Print, or save as PDF: findings and board") { printing.open(isWhole = false) })
            add(MenuEntry("Print all graphs") { printing.open(isWhole = true) })
            add(MenuEntry("Visible range as a table (CSV)") { saveTable(scene, "range", CsvDraft.ofAll(scene.view, shown)) })
            if (cards.isEmpty()) return@buildList
            addAll(imageEntries(scene, "Board") { cards.map { it::drawOn } })
            val lines = cards.flatMap { it.graph.series }.distinct()
            add(MenuEntry("Board as a table (CSV)") { saveTable(scene, "Board", CsvDraft.of(scene.view, shown, lines)) })
        }
    }
}
