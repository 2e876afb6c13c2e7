package badlog.page.dom

import org.w3c.files.File

/** Where the file was, with the names of its folders; null unless the page found that out itself. */
internal var File.place: String?
    get() = asDynamic().place as String?
    set(value) {
        asDynamic().place = value
    }
