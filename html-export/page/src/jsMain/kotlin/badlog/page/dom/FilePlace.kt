package badlog.page.dom

import org.w3c.files.File

/** The path of the file with its folders; null unless the page determined it itself. */
internal var File.place: String?
    get() = asDynamic().place as String?
    set(value) {
        asDynamic().place = value
    }
