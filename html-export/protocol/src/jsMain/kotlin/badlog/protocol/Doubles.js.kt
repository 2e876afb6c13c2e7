package badlog.protocol

import org.khronos.webgl.Float64Array
import org.khronos.webgl.Uint8Array
import org.khronos.webgl.get
import org.khronos.webgl.set

// Every machine that runs a browser is little-endian.
internal actual fun base64OfDoubles(numbers: DoubleArray): String {
    val doubles = numbers.unsafeCast<Float64Array>()
    val bytes = Uint8Array(doubles.buffer, doubles.byteOffset, doubles.byteLength)
    val text = StringBuilder(bytes.length)
    for (i in 0 until bytes.length) text.append((bytes[i].toInt() and 255).toChar())
    return js("btoa")(text.toString()).unsafeCast<String>()
}

internal actual fun doublesOfBase64(base64: String): DoubleArray {
    val text = js("atob")(base64).unsafeCast<String>()
    val bytes = Uint8Array(text.length)
    for (i in text.indices) bytes[i] = text[i].code.toByte()
    return Float64Array(bytes.buffer, 0, text.length / Double.SIZE_BYTES).unsafeCast<DoubleArray>()
}
