package badlog.page.folder

import badlog.page.dom.add
import badlog.page.dom.element
import badlog.protocol.PageFigure
import org.w3c.dom.HTMLElement

/** Returns a picture that a hook drew, with its title above it. */
internal fun hookPicture(figure: PageFigure): HTMLElement = element("figure", "picture card") {
    add("figcaption", "picture-title", figure.title)
    // In an image element, scripts and addresses in the picture have no effect.
    val image = add("img")
    image.setAttribute("alt", figure.title)
    image.addEventListener("error", {
        image.remove()
        add("p", "unit", "This picture cannot be drawn.")
    })
    image.setAttribute("src", "data:${figure.mediaType};base64,${figure.base64}")
}
