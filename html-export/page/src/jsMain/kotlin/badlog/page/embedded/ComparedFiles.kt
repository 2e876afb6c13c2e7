package badlog.page.embedded

import kotlinx.browser.document
import org.w3c.dom.Element
import org.w3c.dom.asList
import org.w3c.files.File
import kotlin.js.Promise

/** Promises the files of the compared logs that this page contains; rejected if one was damaged. */
internal fun comparedFiles(): Promise<List<File>> {
    val files = document.querySelectorAll("script.compared").asList().map { node ->
        val element = node.unsafeCast<Element>()
        val name = element.getAttribute("data-name").orEmpty()
        EmbeddedFile(element).inflated().then { File(arrayOf<dynamic>(it), name).also { file -> file.carrier = element } }
    }
    return Promise.all(files.toTypedArray()).then { it.toList() }
}

/** The script element of this page that contains the file; null for a file from elsewhere. */
internal var File.carrier: Element?
    get() = asDynamic().carrier as Element?
    set(value) {
        asDynamic().carrier = value
    }
