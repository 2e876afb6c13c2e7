package badlog.samples.generated.log

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Writes a WPILOG with arrays and structs, which badlog's own writer would split: one entry per topic, and a record for each change.
 *
 * @param bootSeconds the time on the robot's clock when the log begins.
 * @param keepsRepeats whether repeated values are written, too.
 */
internal class WpilogRecorder(
    private val topics: List<LoggedTopic>,
    private val bootSeconds: Double,
    extraHeader: String,
    private val keepsRepeats: Boolean,
) : Recorder {
    private val out = ByteArrayOutputStream(1 shl 20)
    private val payload = ByteBuffer.allocate(1 shl 16).order(ByteOrder.LITTLE_ENDIAN)
    private val head = ByteBuffer.allocate(17).order(ByteOrder.LITTLE_ENDIAN)
    private val last = arrayOfNulls<ByteArray>(topics.size)
    private val ofLoops = topics.indices.filter { topics[it].everyLoops > 0 }.toIntArray()
    private val ofFrames = topics.indices.filter { topics[it].everyLoops == 0 }.toIntArray()
    private var loops = 0

    init {
        out.writeBytes("WPILOG".toByteArray())
        out.write(byteArrayOf(0, 1))
        payload.clear()
        text(extraHeader)
        out.write(payload.array(), 0, payload.position())
        val start = micros(0.0)
        var id = topics.size
        val structs = topics.mapNotNull { (it.type as? ValueType.Structs)?.struct }.flatMap { it.withParts() }.distinct()
        for (struct in structs) {
            start(++id, "/.schema/struct:${struct.typeName}", "structschema", "", start)
            payload.clear().put(struct.schema.toByteArray())
            record(id, start)
        }
        if (topics.any { it.type is ValueType.Encoded }) {
            start(++id, "DS:/.schema/proto:mrc.proto", "proto:FileDescriptorProto", "", start)
            payload.clear().put(Message.descriptions())
            record(id, start)
        }
        for ((index, topic) in topics.withIndex()) {
            start(index + 1, topic.name, topic.type.name, if (topic.unit == "ul") "" else "{\"unit\":\"${topic.unit}\"}", start)
        }
    }

    private fun micros(time: Double) = Math.round((time + bootSeconds) * 1e6)

    override fun loop(time: Double) {
        for (index in ofLoops) if (loops % topics[index].everyLoops == 0) sample(index, time)
        loops++
    }

    override fun frame(time: Double) {
        for (index in ofFrames) sample(index, time)
    }

    override fun bytes(): ByteArray = out.toByteArray()

    private fun sample(index: Int, time: Double) {
        val topic = topics[index]
        val value = topic.read() ?: return
        payload.clear()
        encode(value, topic.type)
        val size = payload.position()
        val before = last[index]
        if (!keepsRepeats && before != null && before.size == size && before.indices.all { before[it] == payload.array()[it] }) return
        if (before != null && before.size == size) {
            System.arraycopy(payload.array(), 0, before, 0, size)
        } else {
            last[index] = payload.array().copyOf(size)
        }
        record(index + 1, micros(time))
    }

    private fun encode(value: Any, type: ValueType) {
        when (value) {
            is Double -> payload.putDouble(value)

            is Long -> payload.putLong(value)

            is ByteArray -> payload.put(value)

            is Boolean -> payload.put(if (value) 1 else 0)

            is String -> payload.put(value.toByteArray())

            is DoubleArray -> for (number in value) {
                if (type == ValueType.Floats) {
                    payload.putFloat(number.toFloat())
                } else {
                    payload.putDouble(number)
                }
            }

            is List<*> -> {
                payload.putInt(value.size)
                for (text in value) text(text as String)
            }

            else -> error("The type ${value::class} of a value cannot be written.")
        }
    }

    private fun text(text: String) {
        val bytes = text.toByteArray()
        payload.putInt(bytes.size).put(bytes)
    }

    private fun start(id: Int, name: String, type: String, metadata: String, micros: Long) {
        payload.clear().put(0).putInt(id)
        text(name)
        text(type)
        text(metadata)
        record(0, micros)
    }

    /** Writes a record with the collected payload. */
    private fun record(id: Int, micros: Long) {
        val size = payload.position()
        val idSize = sizeOf(id.toLong())
        val sizeSize = sizeOf(size.toLong())
        val timeSize = sizeOf(micros)
        head.clear().put((idSize - 1 or (sizeSize - 1 shl 2) or (timeSize - 1 shl 4)).toByte())
        put(id.toLong(), idSize)
        put(size.toLong(), sizeSize)
        put(micros, timeSize)
        out.write(head.array(), 0, head.position())
        out.write(payload.array(), 0, size)
    }

    private fun sizeOf(number: Long): Int {
        var size = 1
        while (size < 8 && number ushr 8 * size != 0L) size++
        return size
    }

    private fun put(number: Long, width: Int) {
        for (i in 0 until width) head.put((number ushr 8 * i).toByte())
    }
}
