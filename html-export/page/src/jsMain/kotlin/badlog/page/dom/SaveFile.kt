package badlog.page.dom

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLAnchorElement
import org.w3c.dom.HTMLTextAreaElement
import org.w3c.dom.url.URL
import org.w3c.files.Blob
import kotlin.js.Promise

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

/** Copies [text] to the clipboard. Returns whether that was possible. */
internal fun copyText(text: String): Promise<Boolean> {
    val copied = try {
        window.navigator.asDynamic().clipboard.writeText(text).unsafeCast<Promise<Unit>>()
    } catch (_: Throwable) {
        Promise.reject(IllegalStateException())
    }
    return copied.then({ true }, { copyBySelection(text) })
}

/** Copies in a way that works for pages that may not use the clipboard. */
private fun copyBySelection(text: String): Boolean {
    val focused = document.activeElement
    val area = element("textarea").unsafeCast<HTMLTextAreaElement>()
    area.value = text
    document.body?.appendChild(area)
    area.select()
    val isCopied = document.asDynamic().execCommand("copy") == true
    area.remove()
    focused?.asDynamic()?.focus()
    return isCopied
}
