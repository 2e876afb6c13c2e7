package badlog.files

import java.io.BufferedOutputStream
import java.io.FilterOutputStream
import java.io.IOException
import java.io.OutputStream
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import java.util.UUID

/**
 * Creates [target] with the output of [write]: an older file is replaced only by a complete one. Its folder is created if necessary.
 *
 * @throws UnwritableFileException if it cannot be written.
 * @throws InterruptedException if the thread was interrupted.
 */
public fun <T> writeAtomically(target: Path, write: (OutputStream) -> T): T = writing(target) {
    Files.createDirectories(target.toAbsolutePath().normalize().parent)
    AtomicFile(target).use { file ->
        val written = write(file.out)
        file.commit()
        written
    }
}

/**
 * A file that is written atomically. It has another name beside [target] until [commit] replaces [target] with it. If it is closed before
 * that, or the program ends, it is deleted.
 *
 * @throws IOException if the folder cannot be written to.
 */
public class AtomicFile(target: Path) : AutoCloseable {
    private val target = target.toAbsolutePath().normalize()

    // Not a temporary file of the system, which other users could not read after the move.
    private val draft = this.target.resolveSibling(".badlog-${UUID.randomUUID()}.part")

    /** The stream for the content. */
    public val out: OutputStream = BufferedOutputStream(RoomGuard(draft, Files.newOutputStream(draft, CREATE_NEW, WRITE)), 1 shl 16)
    private val cleaner = Thread { Files.deleteIfExists(draft) }

    init {
        Runtime.getRuntime().addShutdownHook(cleaner)
    }

    /** Moves the file to its place, replacing any older one. */
    public fun commit() {
        out.close()
        try {
            Files.move(draft, target, ATOMIC_MOVE)
        } catch (_: AtomicMoveNotSupportedException) {
            Files.move(draft, target, REPLACE_EXISTING)
        }
    }

    /** Removes the file if it was not committed. */
    override fun close() {
        try {
            out.close()
        } catch (_: IOException) {
            // The rest of an uncommitted file is not needed; any failure that matters was thrown before.
        }
        Files.deleteIfExists(draft)
        try {
            Runtime.getRuntime().removeShutdownHook(cleaner)
        } catch (_: IllegalStateException) {
            // The program is ending, and the hook is running.
        }
    }
}

/** Thrown if there was not enough room on the disk. */
internal class DiskFullException(cause: IOException) : IOException(cause)

/** A stream of [file] that distinguishes a full disk from other failures. */
private class RoomGuard(private val file: Path, stream: OutputStream) : FilterOutputStream(stream) {
    override fun write(bytes: ByteArray, from: Int, size: Int) = try {
        out.write(bytes, from, size)
    } catch (e: IOException) {
        // The system's message differs by platform and language, so the remaining room is checked.
        throw if (Files.getFileStore(file).usableSpace < size) DiskFullException(e) else e
    }
}
