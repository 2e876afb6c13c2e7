package badlog.page.embedded

import org.w3c.dom.Element
import org.w3c.files.Blob
import kotlin.js.Promise

/** The bytes of the log that is shown, for downloads and copies. */
internal interface LogBytes {
    /** Returns the bytes of its files, one after the other, exactly as they were when they were exported or opened. */
    fun original(): Promise<Blob>

    /** Returns its text, of which [filter] may remove some of each chunk; null if only what was read from it can be saved. */
    fun text(filter: (ByteArray) -> ByteArray): Promise<Blob>?

    /** Returns what a page holds of it: the log itself and the facts about it, as markup; null if this page already does. */
    fun toMarkup(): Promise<Blob>?
}

/** The log [element] in this page, about which it says [about]. */
internal class EmbeddedLog(private val about: About, element: Element) : LogBytes {
    private val file = EmbeddedFile(element)

    override fun original() = if (about.isCompressed) Promise.resolve(file.compressed()) else file.inflated(about.inflatedBytes)

    override fun text(filter: (ByteArray) -> ByteArray) = file.inflated(about.inflatedBytes, !about.isCompressed, filter)

    override fun toMarkup() = null
}
