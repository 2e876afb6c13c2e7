package badlog.page.dom

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLAnchorElement
import org.w3c.dom.url.URL
import org.w3c.files.Blob

/** Offers [content] as a download named [name]. */
internal fun saveFile(content: Blob, name: String) {
    val link = document.createElement("a").unsafeCast<HTMLAnchorElement>()
    link.href = URL.createObjectURL(content)
    link.download = name
    document.body?.appendChild(link)
    link.click()
    link.remove()
    // The browser reads the bytes after the click, and no event reports that it is done.
    window.setTimeout({ URL.revokeObjectURL(link.href) }, SAVING_MILLISECONDS)
}

private const val SAVING_MILLISECONDS = 60_000
