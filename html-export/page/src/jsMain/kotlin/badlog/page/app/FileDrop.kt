package badlog.page.app

import kotlinx.browser.document
import org.w3c.dom.ItemArrayLike
import org.w3c.dom.asList
import org.w3c.files.File

/** Lets a person drop files anywhere on the page; [onDrop] is called with them. */
internal fun acceptFiles(onDrop: (List<File>) -> Unit) {
    document.addEventListener("dragover", { event -> if (hasFile(event)) event.preventDefault() })
    document.addEventListener("drop", { event ->
        if (!hasFile(event)) return@addEventListener
        event.preventDefault()
        onDrop(event.asDynamic().dataTransfer.files.unsafeCast<ItemArrayLike<File>>().asList())
    })
}

private fun hasFile(event: dynamic): Boolean = event.dataTransfer?.types?.includes("Files") == true
