package badlog.page.embedded

import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import org.w3c.dom.Element
import org.w3c.dom.Node
import org.w3c.dom.Text

/** Base64 with the standard alphabet (RFC 4648), with padding only at the end. */
internal object Base64 {
    private val digits = IntArray(128).also { table ->
        val alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
        for (i in alphabet.indices) table[alphabet[i].code] = i
    }

    /**
     * Returns the bytes of [text], which may end with a line feed. Only whole groups of four characters are decoded; the rest of a cut text
     * is dropped. Characters outside the alphabet result in wrong bytes.
     */
    fun decode(text: String): ByteArray {
        if (text.endsWith('\n')) return decode(text.substring(0, text.length - 1))
        val native = js("Uint8Array")
        if (native.fromBase64 == undefined || text.length % 4 != 0) return decodeByTable(text)
        val bytes = try {
            native.fromBase64(text).unsafeCast<Uint8Array>()
        } catch (_: Throwable) {
            return decodeByTable(text)
        }
        return Int8Array(bytes.buffer, bytes.byteOffset, bytes.length).unsafeCast<ByteArray>()
    }

    /** Returns the same as [decode], but without the browser's decoder, which is missing in browsers before 2025. */
    fun decodeByTable(text: String): ByteArray {
        var characters = text.length
        while (characters > 0 && text[characters - 1] == '=') characters--
        val bytes = ByteArray(characters * 3 / 4)
        var at = 0
        var i = 0
        while (at < bytes.size) {
            val group = (digitAt(text, i) shl 18) or (digitAt(text, i + 1) shl 12) or
                (digitAt(text, i + 2) shl 6) or digitAt(text, i + 3)
            bytes[at++] = (group shr 16).toByte()
            if (at < bytes.size) bytes[at++] = (group shr 8).toByte()
            if (at < bytes.size) bytes[at++] = group.toByte()
            i += 4
        }
        return bytes
    }

    private fun digitAt(text: String, index: Int): Int = if (index < text.length) digits[text[index].code and 127] else 0
}

/**
 * The base64 text of an [element], piece by piece. It can be hundreds of megabytes long, in one text node or in thousands, so it is never
 * concatenated. More of it may arrive while the page loads.
 */
internal class Base64Text(private val element: Element) {
    private var node: Node? = null
    private var offset = 0

    /**
     * Returns the next piece of a line; null if there is no more, or not yet.
     *
     * A piece has at most [PIECE] characters, and a multiple of four if more may follow. The last piece of a line ends with its line feed.
     * Each line can be decoded without the lines before it.
     */
    fun next(): String? {
        var piece = ""
        while (piece.length < PIECE && hasMore()) {
            val text = node.unsafeCast<Text>()
            val isAll = offset == 0 && text.length <= PIECE - piece.length
            // Avoids copying the text of a whole node.
            val taken = if (isAll) text.data else text.substringData(offset, minOf(PIECE - piece.length, text.length - offset))
            val end = taken.indexOf('\n')
            if (end < 0) {
                piece += taken
                offset += taken.length
            } else {
                offset += end + 1
                return piece + taken.substring(0, end + 1)
            }
        }
        return piece.ifEmpty { null }
    }

    private fun hasMore(): Boolean {
        val text = node ?: element.firstChild ?: return false
        node = text
        if (offset < text.unsafeCast<Text>().length) return true
        // The last node may still grow.
        node = text.nextSibling ?: return false
        offset = 0
        return hasMore()
    }

    private companion object {
        const val PIECE = 1 shl 20
    }
}
