package badlog.cli.console

import java.io.IOException
import java.io.OutputStream

/** Passes bytes on to [out], and remembers its last failure, which a print stream does not report. */
internal class ResultStream(private val out: OutputStream) : OutputStream() {
    /** The reason why something could not be written; null if all was written. */
    var failure: IOException? = null
        private set

    /** Whether the program that read the results has ended, such as `head`. */
    val isReaderGone: Boolean get() = failure?.message.orEmpty().contains("pipe", ignoreCase = true)

    override fun write(byte: Int) = write(byteArrayOf(byte.toByte()), 0, 1)

    override fun write(bytes: ByteArray, from: Int, size: Int) = noting { out.write(bytes, from, size) }

    override fun flush() = noting { out.flush() }

    private fun noting(work: () -> Unit) = try {
        work()
    } catch (e: IOException) {
        failure = e
        throw e
    }
}
