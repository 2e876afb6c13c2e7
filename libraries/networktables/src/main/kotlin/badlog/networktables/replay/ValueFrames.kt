package badlog.networktables.replay

import badlog.networktables.TIME_ID
import badlog.networktables.TopicType
import org.msgpack.core.MessageBufferPacker
import org.msgpack.core.MessagePack
import org.msgpack.core.MessagePackException
import org.msgpack.value.ValueType
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Writes values as NT4's binary frames: MessagePack arrays of a topic's id, microseconds, type and value. */
internal class ValueFrames(private val signals: List<ReplayedTopic>) {
    /** Returns [updates] in frames about as long as a network packet, so that a ping never waits for long. */
    fun of(updates: List<Update>): List<ByteBuffer> {
        val frames = ArrayList<ByteBuffer>()
        val packer = MessagePack.newDefaultBufferPacker()
        // The packer keeps counting when it is cleared.
        var begin = 0L
        for (update in updates) {
            pack(packer, update)
            if (packer.totalWrittenBytes - begin < FULL_BYTES) continue
            frames += packer.take()
            begin = packer.totalWrittenBytes
        }
        if (packer.totalWrittenBytes > begin) frames += packer.take()
        return frames
    }

    private fun pack(packer: MessageBufferPacker, update: Update) {
        val signal = signals[update.signal]
        packer.packArrayHeader(4).packInt(update.signal).packLong(update.micros).packInt(signal.type.code)
        val payload = signal.payload
        if (payload != null) return packPayload(packer, signal.type, payload(update.index))
        val value = signal.samples.y[update.index]
        when (signal.type) {
            TopicType.BOOLEAN -> packer.packBoolean(value != 0.0)
            TopicType.INT -> packer.packLong(value.toLong())
            TopicType.STRING -> packText(packer, signal.texts[value.toInt()])
            else -> packer.packDouble(value)
        }
    }

    /** Packs the [bytes] of a value of [type] from a record of a WPILOG. */
    private fun packPayload(packer: MessageBufferPacker, type: TopicType, bytes: ByteArray) {
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        fun array(width: Int, pack: () -> Unit) {
            packer.packArrayHeader(bytes.size / width)
            repeat(bytes.size / width) { pack() }
        }
        when (type) {
            TopicType.BOOLEAN -> packer.packBoolean(bytes[0].toInt() != 0)

            TopicType.INT -> packer.packLong(buffer.getLong())

            TopicType.FLOAT -> packer.packFloat(buffer.getFloat())

            TopicType.DOUBLE -> packer.packDouble(buffer.getDouble())

            TopicType.STRING -> packText(packer, bytes)

            TopicType.RAW -> packer.packBinaryHeader(bytes.size).writePayload(bytes)

            TopicType.BOOLEANS -> array(1) { packer.packBoolean(buffer.get().toInt() != 0) }

            TopicType.INTS -> array(Long.SIZE_BYTES) { packer.packLong(buffer.getLong()) }

            TopicType.FLOATS -> array(Float.SIZE_BYTES) { packer.packFloat(buffer.getFloat()) }

            TopicType.DOUBLES -> array(Double.SIZE_BYTES) { packer.packDouble(buffer.getDouble()) }

            TopicType.STRINGS -> {
                val count = buffer.getInt()
                packer.packArrayHeader(count)
                repeat(count) { packText(packer, ByteArray(buffer.getInt()).also(buffer::get)) }
            }
        }
    }

    private fun packText(packer: MessageBufferPacker, text: ByteArray) {
        packer.packRawStringHeader(text.size).writePayload(text)
    }

    private fun MessageBufferPacker.take(): ByteBuffer = ByteBuffer.wrap(toByteArray()).also { clear() }
}

/**
 * Answers the requests for the time in a client's binary [frame]; other values in it are ignored.
 *
 * @param micros the server's time in µs.
 * @return the answer, or null if there was no request.
 * @throws RuntimeException if the frame is not one of NT4's; the exception is a `MessagePackException`.
 */
internal fun answerTime(frame: ByteBuffer, micros: Long): ByteBuffer? {
    val questions = MessagePack.newDefaultUnpacker(frame)
    val answers = MessagePack.newDefaultBufferPacker()
    while (questions.hasNext()) {
        val size = questions.unpackArrayHeader()
        if (size != 4) throw MessagePackException("an array of $size elements instead of 4")
        val id = questions.unpackLong()
        questions.skipValue(1)
        val type = questions.unpackInt()
        val value = questions.nextFormat.valueType
        if (id == TIME_ID && value == ValueType.INTEGER) {
            answers.packArrayHeader(4).packLong(TIME_ID).packLong(micros).packInt(type)
                .packBigInteger(questions.unpackBigInteger())
        } else if (id == TIME_ID && value == ValueType.FLOAT) {
            answers.packArrayHeader(4).packLong(TIME_ID).packLong(micros).packInt(type).packDouble(questions.unpackDouble())
        } else {
            questions.skipValue()
        }
    }
    return if (answers.totalWrittenBytes == 0L) null else ByteBuffer.wrap(answers.toByteArray())
}

private const val FULL_BYTES = 1200
