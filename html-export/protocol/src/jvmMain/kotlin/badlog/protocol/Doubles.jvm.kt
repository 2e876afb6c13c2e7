package badlog.protocol

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64

internal actual fun base64OfDoubles(numbers: DoubleArray): String {
    val bytes = ByteBuffer.allocate(numbers.size * Double.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN)
    bytes.asDoubleBuffer().put(numbers)
    return Base64.getEncoder().encodeToString(bytes.array())
}

internal actual fun doublesOfBase64(base64: String): DoubleArray {
    val numbers = ByteBuffer.wrap(Base64.getDecoder().decode(base64)).order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer()
    return DoubleArray(numbers.remaining()).also(numbers::get)
}
