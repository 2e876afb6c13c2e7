package badlog.page.embedded

import org.w3c.dom.Element
import org.w3c.files.Blob
import kotlin.js.Promise

/** The bytes of the log that is shown, for downloads and copies. */
internal interface LogBytes {
    /** Returns the bytes of the log's files, one after the other, exactly as they were exported or opened. */
    fun original(): Promise<Blob>

    /** Returns the log's text; [filter] may remove bytes from each chunk. Null if only the recording can be saved. */
    fun text(filter: (ByteArray) -> ByteArray): Promise<Blob>?

    /** Returns the log and the facts about it as markup for a page; null if this page already holds them. */
    fun toMarkup(): Promise<Blob>?
}

/** The log in [element] of this page, with the facts [about] it. */
internal class EmbeddedLog(private val about: About, element: Element) : LogBytes {
    private val file = EmbeddedFile(element)

    override fun original() = if (about.isCompressed) Promise.resolve(file.compressed()) else file.inflated(about.inflatedBytes)

    override fun text(filter: (ByteArray) -> ByteArray) = file.inflated(about.inflatedBytes, !about.isCompressed, filter)

    override fun toMarkup() = null
}
