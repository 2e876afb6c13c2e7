package badlog.lib

import java.io.IOException

/** Where the bytes of a bag go. */
internal interface BagOutput {
    /** How long the file is by now, in bytes. */
    val length: Long

    /** @throws IOException if the bytes could not be written; then the file is as it was before. */
    fun append(bytes: ByteArray, size: Int)

    /** Writes what the end of a file needs. */
    fun finish()

    /** Waits until everything is on the disk. */
    fun sync()

    fun close()
}
