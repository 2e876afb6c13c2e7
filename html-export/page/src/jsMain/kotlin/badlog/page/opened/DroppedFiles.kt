package badlog.page.opened

import badlog.page.dom.PageEvents
import badlog.page.dom.place
import kotlinx.browser.document
import org.w3c.dom.ItemArrayLike
import org.w3c.dom.asList
import org.w3c.files.File
import kotlin.js.Promise

/** Accepts files and folders dropped anywhere on the page. [onDrop] is called with the files, including those in the folders. */
internal fun acceptFiles(onDrop: (List<File>) -> Unit) {
    PageEvents.on(document, "dragover") { event -> if (hasFile(event)) event.preventDefault() }
    PageEvents.on(document, "drop") { event ->
        if (!hasFile(event)) return@on
        event.preventDefault()
        val data = event.asDynamic().dataTransfer
        // The browser empties both when this function returns.
        val files = data.files.unsafeCast<ItemArrayLike<File>>().asList()
        val entries = js("Array").from(data.items).unsafeCast<Array<dynamic>>().map { item -> item.webkitGetAsEntry() }
        if (entries.none { it != null && it.isDirectory == true }) return@on onDrop(files)
        Promise.all(entries.map { filesOf(it) }.toTypedArray()).then { onDrop(it.toList().flatten()) }
    }
}

private fun hasFile(event: dynamic): Boolean = event.dataTransfer?.types?.includes("Files") == true

/** Returns the file of [entry], or all files in its folder and the folders below; skips unreadable ones. */
private fun filesOf(entry: dynamic): Promise<List<File>> = Promise { resolve, _ ->
    when {
        entry == null -> resolve(emptyList())

        entry.isFile == true -> entry.file({ file: File ->
            // The browser forgets the folder of a file from a dropped folder.
            file.place = (entry.fullPath as String).removePrefix("/")
            resolve(listOf(file))
        }, { _: dynamic -> resolve(emptyList()) })

        else -> filesIn(entry.createReader(), emptyList(), resolve)
    }
}

/** Passes [found] and the remaining files of a folder to [resolve]; the browser lists a hundred at a time. */
private fun filesIn(reader: dynamic, found: List<File>, resolve: (List<File>) -> Unit) {
    reader.readEntries({ entries: Array<dynamic> ->
        if (entries.isEmpty()) {
            resolve(found)
        } else {
            Promise.all(entries.map { filesOf(it) }.toTypedArray()).then { filesIn(reader, found + it.toList().flatten(), resolve) }
        }
    }, { _: dynamic -> resolve(found) })
}
