package badlog.files.revlog

import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Writes a WPILOG of numbers to [out], according to WPILib's specification of the data log. */
internal class WpilogOutput(private val out: OutputStream) {
    private val record = ByteBuffer.allocate(RECORD).order(ByteOrder.LITTLE_ENDIAN)
    private var entries = 0

    init {
        out.write("WPILOG".encodeToByteArray() + byteArrayOf(0, 1, 0, 0, 0, 0))
    }

    /** Starts an entry, and returns its id. */
    fun start(name: String, type: String, metadata: String): Int {
        val id = ++entries
        val texts = listOf(name, type, metadata).map { it.encodeToByteArray() }
        val payload = ByteBuffer.allocate(1 + Int.SIZE_BYTES + texts.sumOf { Int.SIZE_BYTES + it.size }).order(ByteOrder.LITTLE_ENDIAN)
        payload.put(0).putInt(id)
        for (text in texts) payload.putInt(text.size).put(text)
        write(0, 0, payload.array(), payload.position())
        return id
    }

    /** Writes a sample of a `double` entry at [millis]. */
    fun number(id: Int, millis: Long, number: Double) {
        record.clear()
        record.putDouble(number)
        write(id, millis, record.array(), Double.SIZE_BYTES)
    }

    /** Writes a sample of a `boolean` entry at [millis]. */
    fun truth(id: Int, millis: Long, isTrue: Boolean) = write(id, millis, byteArrayOf(if (isTrue) 1 else 0), 1)

    /** Writes a sample of a `string` entry at [millis]. */
    fun text(id: Int, millis: Long, text: String) = text.encodeToByteArray().let { write(id, millis, it, it.size) }

    private fun write(id: Int, millis: Long, payload: ByteArray, size: Int) {
        // Each of the three numbers in its full width: 4, 4 and 8 bytes.
        head.clear()
        head.put(FULL_WIDTH).putInt(id).putInt(size).putLong(millis * MICROS)
        out.write(head.array())
        out.write(payload, 0, size)
    }

    private val head = ByteBuffer.allocate(HEAD).order(ByteOrder.LITTLE_ENDIAN)

    private companion object {
        const val RECORD = 8
        const val HEAD = 17
        const val FULL_WIDTH: Byte = 0x7F
        const val MICROS = 1000
    }
}
