package badlog.page.dom

import org.w3c.dom.HTMLElement

/**
 * A dialog with a title, closed by its button, Escape, or a click outside it.
 *
 * @param className the class of its element, in addition to the class of all dialogs.
 * @param build adds the content below the title.
 */
internal class Dialog(id: String, className: String = "", title: String = "", build: HTMLElement.() -> Unit) {
    private lateinit var heading: HTMLElement

    val element: HTMLElement = element("dialog", "dialog $className") {
        this.id = id
        add("div", "dialog-head") {
            heading = add("h2")
            addIconButton("", Icon.CLOSE, "Close") { close() }
        }
        build()
        // A click on the dialog itself is outside its content.
        addEventListener("click", { if (it.target == this) close() })
    }

    /** The title, also its accessible name. */
    var title: String = ""
        set(value) {
            field = value
            heading.showText(value)
            element.setAttribute("aria-label", value)
        }

    val isOpen: Boolean get() = element.hasAttribute("open")

    init {
        this.title = title
    }

    /** Opens the dialog, which must be closed. */
    fun open() {
        element.asDynamic().showModal()
    }

    fun close() {
        element.asDynamic().close()
    }
}
