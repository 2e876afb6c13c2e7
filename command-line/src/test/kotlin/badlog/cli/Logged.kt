package badlog.cli

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import kotlin.math.roundToLong

/**
 * A topic that a test writes into a WPILOG.
 *
 * @property samples times in s, and numbers, truth values or texts.
 */
internal class Logged(val name: String, val type: String, val metadata: String, val samples: List<Pair<Double, Any>>)

/** A WPILOG of [topics] called [name] in this folder, with records in the order of time. It is written byte by byte as the format says. */
internal fun Path.wpilog(name: String, topics: List<Logged>): Path = with(name, wpilogBytes(topics))

/** The bytes of a WPILOG of [topics]. */
internal fun wpilogBytes(topics: List<Logged>): ByteArray {
    val out = ByteArrayOutputStream()
    out.write("WPILOG".encodeToByteArray() + byteArrayOf(0, 1, 0, 0, 0, 0))
    topics.forEachIndexed { index, topic ->
        val texts = listOf(topic.name, topic.type, topic.metadata).map { it.encodeToByteArray() }
        val payload = texts.fold(byteArrayOf(0) + littleEndian(4) { putInt(index + 1) }) { all, text ->
            all + littleEndian(4) { putInt(text.size) } + text
        }
        out.write(record(0, 0.0, payload))
    }
    topics.flatMapIndexed { index, topic -> topic.samples.map { (time, value) -> Triple(time, index, payload(topic.type, value)) } }
        .sortedBy { it.first }
        .forEach { (time, index, payload) -> out.write(record(index + 1, time, payload)) }
    return out.toByteArray()
}

private fun record(id: Int, seconds: Double, payload: ByteArray): ByteArray = byteArrayOf(0x7F) + littleEndian(4) { putInt(id) } + littleEndian(4) { putInt(payload.size) } +
    littleEndian(8) { putLong((seconds * 1e6).roundToLong()) } + payload

private fun payload(type: String, value: Any): ByteArray = when (type) {
    "boolean" -> byteArrayOf(if (value as Boolean) 1 else 0)
    "int64" -> littleEndian(8) { putLong((value as Double).toLong()) }
    "float" -> littleEndian(4) { putFloat((value as Double).toFloat()) }
    "double" -> littleEndian(8) { putDouble(value as Double) }
    else -> value as? ByteArray ?: (value as String).encodeToByteArray()
}

private fun littleEndian(size: Int, put: ByteBuffer.() -> Unit): ByteArray = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN).apply(put).array()
