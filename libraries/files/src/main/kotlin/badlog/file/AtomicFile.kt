package badlog.file

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
 * Makes [target] of what [write] writes: an older file is replaced only by a whole one. Its folder is made if need be.
 *
 * @throws UnwritableFileException when it cannot be written.
 * @throws InterruptedException when the thread was interrupted.
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
 * A file that is there whole or as it was before: it is written under another name beside [target], and takes its place in
 * [commit]. Closed or cut short before that, even by the end of the program, it leaves nothing.
 *
 * @throws IOException when the folder cannot be written to.
 */
public class AtomicFile(target: Path) : AutoCloseable {
    private val target = target.toAbsolutePath().normalize()

    // No temporary file of the system's kind: of those nobody else may read what becomes of them.
    private val draft = this.target.resolveSibling(".badlog-${UUID.randomUUID()}.part")

    /** Where the content goes. */
    public val out: OutputStream = BufferedOutputStream(RoomGuard(draft, Files.newOutputStream(draft, CREATE_NEW, WRITE)), 1 shl 16)
    private val cleaner = Thread { Files.deleteIfExists(draft) }

    init {
        Runtime.getRuntime().addShutdownHook(cleaner)
    }

    /** Puts the file in its place, instead of any older one. */
    public fun commit() {
        out.close()
        try {
            Files.move(draft, target, ATOMIC_MOVE)
        } catch (_: AtomicMoveNotSupportedException) {
            Files.move(draft, target, REPLACE_EXISTING)
        }
    }

    /** Removes what was not committed. */
    override fun close() {
        try {
            out.close()
        } catch (_: IOException) {
            // What was not written is not wanted either; a failure that matters was thrown before.
        }
        Files.deleteIfExists(draft)
        try {
            Runtime.getRuntime().removeShutdownHook(cleaner)
        } catch (_: IllegalStateException) {
            // The program is ending, and the hook runs.
        }
    }
}

/** There was no room on the disk for what was to be written. */
internal class DiskFullException(cause: IOException) : IOException(cause)

/** A stream of [file] whose failures distinguish a full disk from other reasons. */
private class RoomGuard(private val file: Path, stream: OutputStream) : FilterOutputStream(stream) {
    override fun write(bytes: ByteArray, from: Int, size: Int) = try {
        out.write(bytes, from, size)
    } catch (e: IOException) {
        // The system's own words for it differ by platform and language; the room that is left does not.
        throw if (Files.getFileStore(file).usableSpace < size) DiskFullException(e) else e
    }
}
