package badlog.catalog.store

import kotlinx.serialization.DeserializationStrategy
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerializationException
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.AbstractDecoder
import kotlinx.serialization.modules.EmptySerializersModule
import kotlinx.serialization.modules.SerializersModule

/**
 * Reads what [CompactWriter] wrote, from [bytes] after the first [start].
 *
 * @throws RuntimeException such as a `SerializationException`, where something else wrote them.
 */
class CompactReader(private val bytes: ByteArray, start: Int) {
    private inner class Cursor(var at: Int) {
        fun number(): Long {
            var value = 0L
            var shift = 0
            while (true) {
                val byte = bytes[at++].toLong()
                value = value or (byte and LOW_BITS shl shift)
                if (byte >= 0) return value
                shift += BITS
            }
        }

        fun size(): Int = number().also { if (it < 0 || it > bytes.size - at) throw SerializationException("no size: $it") }.toInt()
    }

    private class Block(val start: Int) {
        var isRead = false
        var value: Any? = null
    }

    private val main = Cursor(start)
    private val texts = Array(main.size()) {
        val size = main.size()
        String(bytes, main.at, size, Charsets.UTF_8).also { main.at += size }
    }
    private val blocks = Array(main.size()) {
        val size = main.size()
        Block(main.at).also { main.at += size }
    }

    /** Returns the value that was written. Call it once. */
    fun <T> read(deserializer: DeserializationStrategy<T>): T = Reading(main).decodeSerializableValue(deserializer)

    @OptIn(ExperimentalSerializationApi::class)
    private inner class Reading(private val cursor: Cursor) : AbstractDecoder() {
        override val serializersModule: SerializersModule = EmptySerializersModule()

        override fun <T> decodeSerializableValue(deserializer: DeserializationStrategy<T>): T {
            if (deserializer !is Shared<*>) return super.decodeSerializableValue(deserializer)
            val block = blocks[cursor.number().toInt()]
            if (!block.isRead) {
                block.value = Reading(Cursor(block.start)).decodeSerializableValue(deserializer.whole)
                block.isRead = true
            }
            @Suppress("UNCHECKED_CAST")
            return block.value as T
        }

        // All fields of a class are written, in order.
        override fun decodeSequentially() = true

        override fun decodeElementIndex(descriptor: SerialDescriptor): Int = throw SerializationException("not in order")

        override fun decodeCollectionSize(descriptor: SerialDescriptor): Int = cursor.size()

        override fun decodeNotNullMark() = decodeBoolean()

        override fun decodeBoolean() = bytes[cursor.at++].toInt() != 0

        override fun decodeByte() = bytes[cursor.at++]

        override fun decodeInt() = cursor.number().toInt()

        override fun decodeLong() = cursor.number()

        override fun decodeDouble(): Double {
            var bits = 0L
            for (byte in 0 until Double.SIZE_BYTES) bits = bits or (bytes[cursor.at++].toLong() and BYTE shl (byte * Byte.SIZE_BITS))
            return Double.fromBits(bits)
        }

        override fun decodeString() = texts[cursor.number().toInt()]

        override fun decodeEnum(enumDescriptor: SerialDescriptor): Int = enumDescriptor.getElementIndex(decodeString())
    }

    private companion object {
        const val BITS = 7
        const val LOW_BITS = 0x7FL
        const val BYTE = 0xFFL
    }
}
