package badlog.page.dom

import kotlinx.browser.document
import org.w3c.dom.Worker
import org.w3c.dom.WorkerOptions
import org.w3c.dom.url.URL
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag

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
