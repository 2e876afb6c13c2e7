package badlog.page.section

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.isNarrow
import badlog.page.dom.showText
import badlog.plot.text.countText
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLSelectElement

/** The ways to the folders: a list beside them on a wide screen, a choice in the bar on a narrow one. */
internal class FolderNavigation(private val folders: FolderList) {
    private val links = ArrayList<Pair<HTMLElement, FolderSection>>()
    private val counts = ArrayList<Pair<HTMLElement, FolderSection>>()

    val list: HTMLElement = element("nav", "folder-list") {
        setAttribute("aria-label", "Folders")
        add("div", "folder-list-head") {
            add("span", "", "Folders")
            addButton("text-button", "open all") { folders.openAll() }.id = "expand-all"
            addButton("text-button", "close all") { folders.closeAll() }.id = "collapse-all"
        }
    }

    val choice: HTMLElement = element("select", "folder-choice") {
        setAttribute("aria-label", "Go to a folder")
        addEventListener("change", {
            val select = unsafeCast<HTMLSelectElement>()
            folders.sections.getOrNull(select.selectedIndex - 1)?.reveal()
            select.selectedIndex = 0
        })
    }

    init {
        list()
    }

    /** Lists the folders that there are now. */
    fun list() {
        for ((link, _) in links) link.remove()
        links.clear()
        counts.clear()
        choice.textContent = ""
        choice.add("option", "", if (isNarrow) "Folders" else "Go to folder…")
        for (section in folders.sections) {
            choice.add("option", "", section.shortCaption)
            val link = list.addButton("folder-link", "", section.folder.name) { section.reveal() }.apply {
                add("span", "folder-link-name", section.shortCaption)
                counts += add("span", "count", countText(section.count)) to section
            }
            links += link to section
        }
    }

    /** Shows only the ways to folders that are shown themselves, and how much is in them. */
    fun update() {
        for ((link, section) in links) link.isHidden = section.element.isHidden
        for ((count, section) in counts) count.showText(countText(section.count))
    }
}
