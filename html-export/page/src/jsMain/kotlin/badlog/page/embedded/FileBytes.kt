package badlog.page.embedded

import kotlinx.browser.window
import org.khronos.webgl.ArrayBuffer
import org.khronos.webgl.Int8Array
import org.khronos.webgl.Uint8Array
import org.w3c.fetch.Response
import org.w3c.files.Blob
import kotlin.js.Promise

/** The first bytes of every gzip stream. */
internal val GZIP: ByteArray = byteArrayOf(0x1f, 0x8b.toByte())

/** The end tag of the page's scripts. */
internal const val END: String = "</script>"

/** The number of bytes read at once; a multiple of three, so that base64 pads only the last piece. */
internal const val PIECE: Int = 3 shl 20

/** Returns the bytes of [file] from index [from] until [until], or until its end. */
internal fun bytesOf(file: Blob, from: Double, until: Double): Promise<ByteArray> {
    val part = file.asDynamic().slice(from, until)
    return part.arrayBuffer().unsafeCast<Promise<ArrayBuffer>>().then { Int8Array(it).unsafeCast<ByteArray>() }
}

/** Returns [content], compressed with gzip. */
internal fun packed(content: Blob): Promise<Blob> {
    val stream = content.asDynamic().stream().pipeThrough(js("new CompressionStream('gzip')"))
    return Response(stream).blob()
}

/** Returns [bytes] as Base64 (RFC 4648) in one line, with padding. */
internal fun base64(bytes: ByteArray): String {
    val all = bytes.unsafeCast<Int8Array>().let { Uint8Array(it.buffer, it.byteOffset, it.length) }
    return (0 until all.length step ARGUMENTS).joinToString("") { from ->
        val piece = all.subarray(from, minOf(from + ARGUMENTS, all.length))
        window.btoa(js("String").fromCharCode.apply(null, piece).unsafeCast<String>())
    }
}

/** The number of arguments that a function accepts in every browser; a multiple of three. */
private const val ARGUMENTS = 24_576
