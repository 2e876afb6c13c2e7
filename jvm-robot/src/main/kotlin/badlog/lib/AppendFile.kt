package badlog.lib

import java.io.File
import java.io.IOException
import java.io.RandomAccessFile

/**
 * A file that only grows: one `write` for each [append]. A failed [append] leaves the file unchanged.
 *
 * It uses a [RandomAccessFile] because interrupting a thread does not close it, unlike a channel, and because it
 * writes up to 8 kB via the stack, without allocating a buffer.
 *
 * Guarded by its writers' lock, except [sync] and [close]: a sync may take long, and no writer waits for it.
 *
 * @param file created or truncated; missing folders are created.
 * @param move renames a file, or returns false.
 * @throws IOException if the file cannot be created.
 */
internal class AppendFile(private var file: File, private val move: (from: File, to: File) -> Boolean = File::renameTo) {
    // Held while the file is synced, replaced or closed.
    private val syncing = Any()
    private var access: RandomAccessFile
    private var isClosed = false

    /** Whether [access] was closed for renaming and is not reopened yet. */
    private var isDetached = false
    private var isTorn = false

    /** The number of bytes appended. */
    var length: Long = 0
        private set

    init {
        file.absoluteFile.parentFile?.mkdirs()
        access = RandomAccessFile(file, "rw")
        try {
            access.setLength(0)
        } catch (failure: IOException) {
            // Not a regular file, such as a pipe: it has no length to reset.
            if (file.isFile) throw failure
        }
    }

    /**
     * Appends the first [size] of [bytes].
     *
     * @throws IOException if not all could be written. Then none are in the file, and the next call may try again.
     */
    fun append(bytes: ByteArray, size: Int) {
        if (isDetached) reopen()
        if (isTorn) cutTornEnd()
        try {
            access.write(bytes, 0, size)
        } catch (failure: IOException) {
            isTorn = true
            try {
                cutTornEnd()
            } catch (_: IOException) {
                // Tried again before the next row; a file that has disappeared cannot be truncated.
            }
            throw failure
        }
        length += size
    }

    /** Waits until everything is on the disk. Call it only on a thread that has nothing else to do. */
    fun sync() = synchronized(syncing) { if (!isDetached) access.fd.sync() }

    fun close() = synchronized(syncing) {
        isClosed = true
        access.close()
    }

    /** Renames the file. Writers must hold [lock] while they append. If renaming fails, returns false, and the name is unchanged. */
    fun rename(to: File, lock: Any): Boolean {
        if (move(file, to)) {
            file = to
            return true
        }
        // Windows does not rename an open file. In this order: a writer must not wait for a sync.
        return synchronized(syncing) { synchronized(lock) { renameClosed(to) } }
    }

    private fun renameClosed(to: File): Boolean {
        if (isClosed) return false
        isDetached = true
        try {
            access.close()
        } catch (_: IOException) {
            // Everything written is in the file, or counted as missed.
        }
        val isRenamed = move(file, to)
        if (isRenamed) file = to
        try {
            reopen()
        } catch (_: IOException) {
            // Tried again before the next row, which counts as missed if that fails, too.
        }
        return isRenamed
    }

    private fun reopen() {
        access = RandomAccessFile(file, "rw")
        isDetached = false
        // Goes on behind the last row.
        isTorn = true
    }

    private fun cutTornEnd() {
        access.setLength(length)
        access.seek(length)
        isTorn = false
    }
}
