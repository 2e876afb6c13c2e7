package badlog.page.embedded

import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import org.w3c.dom.Element
import org.w3c.files.Blob
import kotlin.js.Promise

/** A file that the page carries as base64 in a script element. */
internal class EmbeddedFile(private val element: Element) {
    /** The bytes as the page carries them: a gzip stream. */
    fun compressed(): Blob {
        val parts = BlobParts()
        val text = Base64Text(element)
        while (true) parts.add(Base64.decode(text.next() ?: break))
        return parts.toBlob()
    }

    /** The bytes that the page's gzip stream inflates to; [filter] may take some of a chunk's away. */
    fun inflated(
        expectedBytes: Double = Double.POSITIVE_INFINITY,
        isWhole: Boolean = true,
        filter: (ByteArray) -> ByteArray = { it },
    ): Promise<Blob> {
        val parts = BlobParts()
        val inflation = Inflation(expectedBytes, isWhole) { parts.add(filter(it)) }
        val text = Base64Text(element)
        fun feed() {
            val piece = text.next()
            if (piece == null) inflation.end() else inflation.accept(Base64.decode(piece)).then { feed() }
        }
        feed()
        return inflation.finished.then { parts.toBlob() }
    }

    /** Gathers bytes, handing them to the browser's blob store every now and then, which may be on disk. */
    private class BlobParts {
        private var blob = Blob()
        private var parts = ArrayList<Any>()
        private var bytes = 0

        fun add(chunk: ByteArray) {
            val view = chunk.unsafeCast<Int8Array>()
            parts.add(Uint8Array(view.buffer, view.byteOffset, view.length))
            bytes += chunk.size
            if (bytes > HELD_BYTES) fold()
        }

        fun toBlob(): Blob {
            fold()
            return blob
        }

        private fun fold() {
            blob = Blob((listOf<Any>(blob) + parts).toTypedArray())
            parts = ArrayList()
            bytes = 0
        }
    }

    private companion object {
        const val HELD_BYTES = 1 shl 23
    }
}
