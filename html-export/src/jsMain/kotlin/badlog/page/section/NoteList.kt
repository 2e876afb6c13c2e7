package badlog.page.section

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.view.Scene
import badlog.plot.text.countText
import badlog.plot.text.decimalsFor
import badlog.plot.text.fixedText
import org.w3c.dom.HTMLElement

/** What people wrote about moments of the recording, each with the way there; hidden where there is nothing. */
internal fun noteList(scene: Scene): HTMLElement = element("section", "notes-written findings card") {
    id = "notes"
    setAttribute("aria-label", "Notes")
    isHidden = scene.notes.isEmpty()
    val decimals = decimalsFor(scene.range.full.width)
    add("header", "graph-head") {
        add("h2", "findings-title", "Notes")
        add("span", "unit", countText(scene.notes.size, "note"))
    }
    add("ul", "note-rows") {
        for (note in scene.notes) {
            add("li", "note-row") {
                addButton("event-go", fixedText(note.x, decimals), "Show what is around it") { scene.zoomTo(note.x, note.x) }
                add("span", "note-text", note.text)
            }
        }
    }
}
