package badlog.page.opened

import badlog.page.dom.PageEvents
import badlog.page.dom.place
import kotlinx.browser.document
import org.w3c.dom.ItemArrayLike
import org.w3c.dom.asList
import org.w3c.files.File
import kotlin.js.Promise

/**
 * Accepts files and folders dropped anywhere on the page. Calls [onFolder] if a single folder is dropped, and the browser lets the page
 * look into it again. Otherwise calls [onDrop] with the files, including files in folders.
 */
internal fun acceptFiles(onFolder: ((WatchedFolder) -> Unit)? = null, onDrop: (List<File>) -> Unit) {
    PageEvents.on(document, "dragover") { event -> if (hasFile(event)) event.preventDefault() }
    PageEvents.on(document, "drop") { event ->
        if (!hasFile(event)) return@on
        event.preventDefault()
        val data = event.asDynamic().dataTransfer
        // The browser empties both when this function returns.
        val files = data.files.unsafeCast<ItemArrayLike<File>>().asList()
        val items = js("Array").from(data.items).unsafeCast<Array<dynamic>>()
        val entries = items.map { item -> item.webkitGetAsEntry() }
        if (entries.none { it != null && it.isDirectory == true }) return@on onDrop(files)
        handlesOf(items).then({ handles ->
            val folder = handles.singleOrNull()?.let { WatchedFolder(it) }
            if (folder != null && onFolder != null) return@then onFolder(folder)
            Promise.all(handles.map { WatchedFolder.filesOf(it) }.toTypedArray()).then { onDrop(it.toList().flatten()) }
        }, {
            Promise.all(entries.map { filesOf(it) }.toTypedArray()).then { onDrop(it.toList().flatten()) }
        })
    }
}

/**
 * Promises the handles of [items], the way to a folder in Chromium. Chromium does not list entries for pages on a disk. Rejected if the
 * browser has no handles. Call it while the files are dropped.
 */
private fun handlesOf(items: Array<dynamic>): Promise<Array<out Any>> = try {
    Promise.all(items.map { it.getAsFileSystemHandle().unsafeCast<Promise<Any>>() }.toTypedArray())
} catch (problem: Throwable) {
    Promise.reject(problem)
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
