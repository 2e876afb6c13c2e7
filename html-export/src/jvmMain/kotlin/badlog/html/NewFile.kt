package badlog.html

import java.io.BufferedOutputStream
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
 * A file that is there whole or not at all: it is written under another name beside [target], and takes its place in
 * [commit]. Closed or cut short before that, even by the end of the program, it leaves nothing.
 *
 * @throws IOException when the folder cannot be written to.
 */
public class NewFile(private val target: Path) : AutoCloseable {
    private val draft = target.resolveSibling(".badlog-${UUID.randomUUID()}.part")

    /** Where the content goes. */
    public val out: OutputStream =
        BufferedOutputStream(RoomGuard(draft, Files.newOutputStream(draft, CREATE_NEW, WRITE)), 1 shl 16)
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
