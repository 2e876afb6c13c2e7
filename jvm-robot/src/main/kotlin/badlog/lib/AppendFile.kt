package badlog.lib

import java.io.File
import java.io.IOException
import java.io.RandomAccessFile

/**
 * A file that only grows, by one `write` for each [append]. A failed [append] leaves nothing behind.
 *
 * A [RandomAccessFile] because a thread that is interrupted does not close it, as it does a channel; and because up to
 * 8 kB go through the stack, without a buffer being made.
 *
 * @param file created or emptied; its folders are created.
 * @throws IOException if that fails.
 */
internal class AppendFile(file: File) {
    private val access: RandomAccessFile
    private var isTorn = false

    /** How many bytes were appended. */
    var length: Long = 0
        private set

    init {
        file.absoluteFile.parentFile?.mkdirs()
        access = RandomAccessFile(file, "rw")
        try {
            access.setLength(0)
        } catch (failure: IOException) {
            // Not a regular file, such as a pipe: it has no length to set.
            if (file.isFile) throw failure
        }
    }

    /** @throws IOException if not all bytes could be written; then none are, and the next call may try again. */
    fun append(bytes: ByteArray, size: Int) {
        if (isTorn) cutTornEnd()
        try {
            access.write(bytes, 0, size)
        } catch (failure: IOException) {
            isTorn = true
            try {
                cutTornEnd()
            } catch (_: IOException) {
                // Tried again before the next row; a file that has vanished cannot be cut.
            }
            throw failure
        }
        length += size
    }

    /** Waits until everything is on the disk. To be called by no thread that has anything else to do. */
    fun sync() = access.fd.sync()

    fun close() = access.close()

    private fun cutTornEnd() {
        access.setLength(length)
        access.seek(length)
        isTorn = false
    }
}
