package badlog.page.dom

import org.w3c.files.File

/** The path of the file, including its folders, if the page determined it itself; otherwise null. */
internal var File.place: String?
    get() = asDynamic().place as String?
    set(value) {
        asDynamic().place = value
    }
