package badlog.page.embedded

import org.w3c.dom.Element
import org.w3c.files.Blob
import kotlin.js.Promise

/** A file embedded in the page as base64 in a script element. */
internal class EmbeddedFile(private val element: Element) {
    /** Returns the bytes as they are in the page: a gzip stream. */
    fun compressed(): Blob {
        val parts = BlobParts()
        val text = Base64Text(element)
        while (true) parts.addBytes(Base64.decode(text.next() ?: break))
        return parts.toBlob()
    }

    /**
     * Returns the bytes that the page's gzip stream inflates to; [filter] may remove bytes from each chunk.
     *
     * Fails if [expectedBytes] is not given and the browser found an error in the stream.
     */
    fun inflated(
        expectedBytes: Double = Double.POSITIVE_INFINITY,
        isWhole: Boolean = true,
        filter: (ByteArray) -> ByteArray = { it },
    ): Promise<Blob> {
        val parts = BlobParts()
        val inflation = Inflation(expectedBytes, isWhole) { parts.addBytes(filter(it)) }
        val text = Base64Text(element)
        fun feed() {
            val piece = text.next()
            if (piece == null) inflation.end() else inflation.accept(Base64.decode(piece)).then { feed() }
        }
        feed()
        return inflation.finished.then {
            check(!inflation.hasFailed || expectedBytes.isFinite()) { "it was damaged in copying; export the page again." }
            parts.toBlob()
        }
    }
}
