package badlog.page.dom

import kotlinx.browser.document
import org.w3c.dom.Worker
import org.w3c.dom.WorkerOptions
import org.w3c.dom.url.URL
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import org.w3c.files.File

private val address by lazy {
    val script = document.getElementById("program")?.textContent.orEmpty()
    URL.createObjectURL(Blob(arrayOf(script), BlobPropertyBag("text/javascript")))
}

/** Starts a worker named [name] that runs the page's own script. Returns null if the browser forbids it for pages on a disk. */
internal fun startWorker(name: String = ""): Worker? = try {
    Worker(address, json("name" to name).unsafeCast<WorkerOptions>())
} catch (_: Throwable) {
    null
}

/** Returns the milliseconds that work may take before the page must respond: [seen], or more if the page is hidden. */
internal fun sliceMillis(seen: Int): Int = if (document.asDynamic().hidden == true) HIDDEN else seen

/** A browser wakes a hidden page only once a second. */
private const val HIDDEN = 800

/** The path of the file, including its folders, if the page determined it itself; otherwise null. */
internal var File.place: String?
    get() = asDynamic().place as String?
    set(value) {
        asDynamic().place = value
    }
