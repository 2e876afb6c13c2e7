package badlog.page.embedded

import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array

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
