package badlog.page.embedded

import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import org.w3c.files.Blob

/** Collects the parts of a file. From time to time it passes them to the browser's blob store, which may be on disk. */
internal class BlobParts {
    private var blob = Blob()
    private var parts = ArrayList<Any>()
    private var length = 0

    /** Adds [text]. */
    fun add(text: String) = add(text, text.length)

    /** Adds [part]. */
    fun add(part: Blob) = add(part, part.size.toInt())

    /** Adds [bytes]. */
    fun addBytes(bytes: ByteArray) {
        val view = bytes.unsafeCast<Int8Array>()
        add(Uint8Array(view.buffer, view.byteOffset, view.length), bytes.size)
    }

    /** Returns the file. */
    fun toBlob(): Blob {
        fold()
        return blob
    }

    private fun add(part: Any, size: Int) {
        parts.add(part)
        length += size
        if (length > HELD) fold()
    }

    private fun fold() {
        blob = Blob((listOf<Any>(blob) + parts).toTypedArray())
        parts = ArrayList()
        length = 0
    }
}

private const val HELD = 1 shl 23
