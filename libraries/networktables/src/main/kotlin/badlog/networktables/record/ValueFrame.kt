package badlog.networktables.record

import badlog.networktables.TIME_ID
import badlog.networktables.TopicType
import org.msgpack.core.MessageInsufficientBufferException
import org.msgpack.core.MessagePack
import org.msgpack.core.MessagePackException
import org.msgpack.core.MessageUnpacker
import org.msgpack.value.ValueType
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Receives the values of a frame. */
internal interface ValueSink {
    /** Returns the type of the topic [id]; null if its values are not recorded. */
    fun typeOf(id: Long): TopicType?

    /** Receives a value of topic [id] with the server's time and its [payload] as in a WPILOG record. */
    fun value(id: Long, micros: Long, payload: ByteArray)

    /** Receives the server's time [serverMicros], in answer to a request sent at [sentMicros]. */
    fun time(serverMicros: Long, sentMicros: Long)

    /** Called when a value is left out because of [what], part of a sentence. */
    fun ignored(what: String)
}

/**
 * Reads the binary frame [frame] of NetworkTables 4. It has MessagePack arrays of a topic's id, the server's time, a type's code and a
 * value. Everything after the first invalid array is ignored.
 */
internal fun readValues(frame: ByteArray, sink: ValueSink) {
    val unpacker = MessagePack.newDefaultUnpacker(frame)
    try {
        while (unpacker.hasNext()) if (!readValue(unpacker, frame.size, sink)) return
    } catch (_: MessageInsufficientBufferException) {
        sink.ignored("incomplete values")
    } catch (_: MessagePackException) {
        sink.ignored("values that are not MessagePack")
    }
}

/** Returns the number of values in [frame], without reading them. */
internal fun countValues(frame: ByteArray): Int {
    val unpacker = MessagePack.newDefaultUnpacker(frame)
    var count = 0
    try {
        while (unpacker.hasNext()) {
            unpacker.skipValue()
            count++
        }
    } catch (_: MessagePackException) {
        // Unreadable content does not count.
    }
    return count
}

/** Returns a frame that requests the server's time; the answer repeats [micros]. */
internal fun timeRequest(micros: Long): ByteBuffer {
    val packer = MessagePack.newDefaultBufferPacker()
    packer.packArrayHeader(ELEMENTS).packLong(TIME_ID).packLong(0).packInt(TopicType.INT.code).packLong(micros)
    return ByteBuffer.wrap(packer.toByteArray())
}

private fun readValue(unpacker: MessageUnpacker, frameSize: Int, sink: ValueSink): Boolean {
    if (unpacker.nextFormat.valueType != ValueType.ARRAY || unpacker.unpackArrayHeader() != ELEMENTS) {
        sink.ignored("values that are not arrays of four")
        return false
    }
    val id = unpacker.unpackLong()
    val micros = unpacker.unpackLong()
    val code = unpacker.unpackInt()
    if (id == TIME_ID) {
        if (unpacker.nextFormat.valueType == ValueType.INTEGER) {
            sink.time(micros, unpacker.unpackLong())
        } else {
            unpacker.skipValue()
        }
        return true
    }
    val type = sink.typeOf(id)
    if (type == null) {
        unpacker.skipValue()
        return true
    }
    val payload = if (type.code == code) payload(unpacker, type, frameSize - unpacker.totalReadBytes) else null
    if (payload != null) {
        sink.value(id, micros, payload)
    } else {
        // The array may be half read, so everything after it is unreadable.
        if (type.code != code) unpacker.skipValue()
        sink.ignored("a value of another type than its topic")
        return type.code != code
    }
    return true
}

/** Returns the next value as a WPILOG payload of [type]. Null if it has another type, or does not fit in [left] bytes. */
private fun payload(unpacker: MessageUnpacker, type: TopicType, left: Long): ByteArray? = when (type) {
    TopicType.BOOLEAN -> boolean(unpacker)?.let { byteArrayOf(it) }
    TopicType.DOUBLE -> double(unpacker)?.let { bytes(Double.SIZE_BYTES).putDouble(it).array() }
    TopicType.FLOAT -> double(unpacker)?.let { bytes(Float.SIZE_BYTES).putFloat(it.toFloat()).array() }
    TopicType.INT -> int(unpacker)?.let { bytes(Long.SIZE_BYTES).putLong(it).array() }
    TopicType.STRING -> string(unpacker, left)
    TopicType.RAW -> raw(unpacker, left)
    TopicType.BOOLEANS -> array(unpacker, left, 1) { out -> boolean(unpacker)?.let(out::put) }
    TopicType.DOUBLES -> array(unpacker, left, Double.SIZE_BYTES) { out -> double(unpacker)?.let(out::putDouble) }
    TopicType.FLOATS -> array(unpacker, left, Float.SIZE_BYTES) { out -> double(unpacker)?.let { out.putFloat(it.toFloat()) } }
    TopicType.INTS -> array(unpacker, left, Long.SIZE_BYTES) { out -> int(unpacker)?.let(out::putLong) }
    TopicType.STRINGS -> strings(unpacker, left)
}

private fun boolean(unpacker: MessageUnpacker): Byte? =
    if (unpacker.nextFormat.valueType == ValueType.BOOLEAN) (if (unpacker.unpackBoolean()) 1 else 0) else null

/** Some programs send integers, even for a topic of `double`. */
private fun double(unpacker: MessageUnpacker): Double? = when (unpacker.nextFormat.valueType) {
    ValueType.FLOAT -> unpacker.unpackDouble()
    ValueType.INTEGER -> unpacker.unpackLong().toDouble()
    else -> null
}

private fun int(unpacker: MessageUnpacker): Long? = if (unpacker.nextFormat.valueType == ValueType.INTEGER) unpacker.unpackLong() else null

private fun string(unpacker: MessageUnpacker, left: Long): ByteArray? {
    if (unpacker.nextFormat.valueType != ValueType.STRING) return null
    val size = unpacker.unpackRawStringHeader()
    return if (size <= left) unpacker.readPayload(size) else null
}

private fun raw(unpacker: MessageUnpacker, left: Long): ByteArray? {
    if (unpacker.nextFormat.valueType == ValueType.STRING) return string(unpacker, left)
    if (unpacker.nextFormat.valueType != ValueType.BINARY) return null
    val size = unpacker.unpackBinaryHeader()
    return if (size <= left) unpacker.readPayload(size) else null
}

/** Reads an array. Its announced size is checked against the frame's before memory is allocated. */
private inline fun array(unpacker: MessageUnpacker, left: Long, width: Int, read: (ByteBuffer) -> Any?): ByteArray? {
    if (unpacker.nextFormat.valueType != ValueType.ARRAY) return null
    val size = unpacker.unpackArrayHeader()
    if (size > left || size.toLong() * width > MAX_PAYLOAD) return null
    val out = bytes(size * width)
    repeat(size) { read(out) ?: return null }
    return out.array()
}

private fun strings(unpacker: MessageUnpacker, left: Long): ByteArray? {
    if (unpacker.nextFormat.valueType != ValueType.ARRAY) return null
    val size = unpacker.unpackArrayHeader()
    if (size > left) return null
    val out = ByteArrayOutputStream()
    out.write(bytes(Int.SIZE_BYTES).putInt(size).array())
    repeat(size) {
        val text = string(unpacker, left) ?: return null
        if (out.size() + text.size > MAX_PAYLOAD) return null
        out.write(bytes(Int.SIZE_BYTES).putInt(text.size).array())
        out.write(text)
    }
    return out.toByteArray()
}

private fun bytes(size: Int) = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN)

/** Readers of WPILOGs treat longer payloads as damage. */
private const val MAX_PAYLOAD = 16 shl 20

private const val ELEMENTS = 4
