package badlog.page.dom

import org.w3c.dom.HTMLElement

/**
 * A dialog with a title, which its button, Escape and a click beside it close.
 *
 * @param className the class of its element, besides the one that all dialogs have.
 * @param build makes what is below the title.
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

    /** What it is called, also for those who hear it. */
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

    /** Opens it; it must be closed. */
    fun open() {
        element.asDynamic().showModal()
    }

    fun close() {
        element.asDynamic().close()
    }
}
