package badlog.page.dom

import kotlinx.browser.document
import org.w3c.dom.Element

/** The icons of buttons, as strokes in a 16 by 16 square. */
internal enum class Icon(private val path: String) {
    DOWNLOAD("M8 2v8M4.5 7 8 10.5 11.5 7M2.5 13.5h11"),
    TABLE("M2.5 3.5h11v9h-11zM2.5 6.5h11M6.5 6.5v6"),
    CLIP("M12.5 7 7.8 11.7a2.6 2.6 0 0 1-3.7-3.7l5-5a1.8 1.8 0 0 1 2.6 2.6l-5 5a.9.9 0 0 1-1.3-1.3L10 4.7"),
    SEARCH("M7 2.5a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9zM10.3 10.3l3.7 3.7"),
    HELP("M5.5 6a2.5 2.5 0 1 1 3.4 2.3c-.6.3-.9.7-.9 1.5M8 12.4v.1"),
    AUTO("M8 2.5a5.5 5.5 0 1 1 0 11zM8 2.5a5.5 5.5 0 0 0 0 11z"),
    SUN("M8 5a3 3 0 1 1 0 6 3 3 0 0 1 0-6zM8 1v1.5M8 13.5V15M1 8h1.5M13.5 8H15M3 3l1 1M12 12l1 1M3 13l1-1M12 4l1-1"),
    MOON("M13 9.6A5.6 5.6 0 0 1 6.4 3 5.6 5.6 0 1 0 13 9.6z"),
    LIST("M2.5 4h4M2.5 8h4M2.5 12h4M9.5 4h4M9.5 8h4M9.5 12h4"),
    BARS("M2.5 13.5h11M4.5 13.5v-3M8 13.5v-10M11.5 13.5v-6"),
    SUM("M12 3H4l4 5-4 5h8"),
    IMAGE("M2.5 3.5h11v9h-11zM2.5 10.5l3.2-3 2.6 2.3 2-1.8 3.2 2.9M10.5 6.2v.1"),
    CHEVRON("M6 3.5 10.5 8 6 12.5"),
    BACK("M6.5 4 2.5 8l4 4M2.5 8h11"),
    RESET("M2.5 3v10M13.5 3v10M5 8h6M6.5 6.3 4.8 8l1.7 1.7M9.5 6.3 11.2 8 9.5 9.7"),
    PLUS("M8 3v10M3 8h10"),
    MINUS("M3 8h10"),
    FORMULA("M11.5 3.3c-1.9-.9-2.9.1-3.2 1.9l-1.5 6c-.4 1.7-1.3 2.3-3 1.6M5 7h5.5"),
    CLOSE("M4 4l8 8M12 4l-8 8"),
    PIN("M6 2.5h4M6.8 2.5v4.2L4.5 9.5h7L9.2 6.7V2.5M8 9.5V14"),
    START("M2.5 8 8 3l5.5 5M4 7v6h8V7"),
    LAYOUT("M2.5 2.5h11v4h-11zM2.5 9.5h5v4h-5zM10.5 9.5h3v4h-3z"),
    LINK(
        "M6.8 9.2a2.5 2.5 0 0 0 3.6 0l2.1-2.1a2.5 2.5 0 0 0-3.6-3.6l-.7.7M9.2 6.8a2.5 2.5 0 0 0-3.6 0L3.5 8.9a2.5 2.5 0 0 0 3.6 3.6l.7-.7",
    ),
    MORE("M3.5 8v.1M8 8v.1M12.5 8v.1"),
    UNDO("M5.5 3.5 2.5 6.5l3 3M2.5 6.5h7a3.5 3.5 0 0 1 0 7H6"),
    VIDEO("M1.5 4h9v8h-9zM10.5 7l4-2.5v7l-4-2.5"),
    NOTE("M3 13l.8-3.2 7-7 2.4 2.4-7 7zM9.3 4.3l2.4 2.4"),
    COMPARE("M2.5 10.5l3-4 3 2.5 5-5.5M2.5 13.5l3-2.5 3 1.5 5-4"),
    FOLDER("M2 12.5v-9h4l1.5 2H14v7z"),
    SEND("M13.5 2.5 2.5 7l4.5 2 2 4.5zM13.5 2.5 7 9"),
    WHEELS("M4.5 4.5h7v7h-7zM2.5 2v5M13.5 2v5M2.5 9v5M13.5 9v5"),
    OPEN("M8 10.5v-8M4.5 6 8 2.5 11.5 6M2.5 13.5h11"),
    ;

    private val picture by lazy {
        val picture = document.createElementNS(SVG, "svg")
        picture.setAttribute("viewBox", "0 0 16 16")
        picture.setAttribute("class", "icon")
        picture.setAttribute("aria-hidden", "true")
        val line = document.createElementNS(SVG, "path")
        line.setAttribute("d", path)
        picture.appendChild(line)
        picture
    }

    /** Returns a new picture of this icon, in the color of the text around it. */
    fun draw(): Element = picture.cloneNode(true).unsafeCast<Element>()

    companion object {
        /** The namespace of pictures. */
        const val SVG = "http://www.w3.org/2000/svg"
    }
}
