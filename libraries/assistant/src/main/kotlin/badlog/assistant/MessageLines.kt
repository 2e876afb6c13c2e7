package badlog.assistant

import java.io.ByteArrayOutputStream
import java.io.OutputStream

/** Passes whole lines to [out], so that messages of several threads do not mix. Thread-safe. */
internal class MessageLines(private val out: OutputStream) : OutputStream() {
    private val pending = ByteArrayOutputStream()

    /** Writes [message], a line without its line break. */
    @Synchronized
    fun send(message: String) {
        out.write("$message\n".encodeToByteArray())
        out.flush()
    }

    override fun write(byte: Int) = write(byteArrayOf(byte.toByte()))

    @Synchronized
    override fun write(bytes: ByteArray, offset: Int, length: Int) {
        pending.write(bytes, offset, length)
        if (length == 0 || bytes[offset + length - 1] != LINE_FEED) return
        pending.writeTo(out)
        pending.reset()
        out.flush()
    }

    @Synchronized
    override fun close() {
        pending.writeTo(out)
        out.close()
    }
}

private const val LINE_FEED: Byte = 10
