package badlog.catalog.store

import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.SerializationStrategy
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.AbstractEncoder
import kotlinx.serialization.encoding.CompositeEncoder
import kotlinx.serialization.modules.EmptySerializersModule
import kotlinx.serialization.modules.SerializersModule
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer

/**
 * Writes values as bytes that [CompactReader] reads with the same serializers: without names, each text once, and each [Shared] value
 * once, however often they come.
 */
class CompactWriter {
    private val texts = LinkedHashMap<String, Int>()
    private val shared = LinkedHashMap<ByteBuffer, Int>()

    /** Returns [value] as bytes. Call it once. */
    fun <T> write(serializer: SerializationStrategy<T>, value: T): ByteArray {
        val body = Bytes()
        Writing(body).encodeSerializableValue(serializer, value)
        val all = Bytes()
        all.number(texts.size.toLong())
        for (text in texts.keys) all.block(text.encodeToByteArray())
        all.number(shared.size.toLong())
        for (block in shared.keys) all.block(block.array())
        body.writeTo(all)
        return all.toByteArray()
    }

    private class Bytes : ByteArrayOutputStream() {
        /** Writes seven bits per byte, the lowest first, since most numbers are small. */
        fun number(value: Long) {
            var rest = value
            while (rest and LOW_BITS.inv() != 0L) {
                write((rest and LOW_BITS or MORE).toInt())
                rest = rest ushr BITS
            }
            write(rest.toInt())
        }

        fun block(bytes: ByteArray) {
            number(bytes.size.toLong())
            write(bytes, 0, bytes.size)
        }
    }

    @OptIn(ExperimentalSerializationApi::class)
    private inner class Writing(private val out: Bytes) : AbstractEncoder() {
        override val serializersModule: SerializersModule = EmptySerializersModule()

        override fun <T> encodeSerializableValue(serializer: SerializationStrategy<T>, value: T) {
            if (serializer !is Shared<*>) return super.encodeSerializableValue(serializer, value)
            val block = Bytes()
            @Suppress("UNCHECKED_CAST")
            Writing(block).encodeSerializableValue(serializer.whole as SerializationStrategy<T>, value)
            out.number(shared.getOrPut(ByteBuffer.wrap(block.toByteArray())) { shared.size }.toLong())
        }

        override fun shouldEncodeElementDefault(descriptor: SerialDescriptor, index: Int) = true

        override fun beginCollection(descriptor: SerialDescriptor, collectionSize: Int): CompositeEncoder {
            out.number(collectionSize.toLong())
            return this
        }

        override fun encodeNull() = out.write(0)

        override fun encodeNotNullMark() = out.write(1)

        override fun encodeBoolean(value: Boolean) = out.write(if (value) 1 else 0)

        override fun encodeByte(value: Byte) = out.write(value.toInt())

        override fun encodeInt(value: Int) = encodeLong(value.toLong())

        override fun encodeLong(value: Long) = out.number(value)

        override fun encodeDouble(value: Double) {
            val bits = value.toRawBits()
            for (byte in 0 until Double.SIZE_BYTES) out.write((bits ushr (byte * Byte.SIZE_BITS)).toInt())
        }

        override fun encodeString(value: String) = out.number(texts.getOrPut(value) { texts.size }.toLong())

        override fun encodeEnum(enumDescriptor: SerialDescriptor, index: Int) = encodeString(enumDescriptor.getElementName(index))
    }

    private companion object {
        const val BITS = 7
        const val LOW_BITS = 0x7FL
        const val MORE = 0x80L
    }
}
