package badlog.viewer.files

import java.io.BufferedOutputStream
import java.io.IOException
import java.io.InterruptedIOException
import java.io.OutputStream
import java.nio.channels.ClosedByInterruptException
import java.nio.file.AccessDeniedException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import java.util.UUID

/**
 * Writes [target] by [write], so that it is there whole or not at all: an older one is replaced only in the end.
 *
 * @throws IOException with a sentence for the person, when that cannot be done.
 */
internal fun writeWhole(target: Path, write: (OutputStream) -> Unit) {
    val file = target.toAbsolutePath().normalize()
    try {
        Files.createDirectories(file.parent)
        // No temporary file of the system's kind: of those nobody else may read what becomes of them.
        val draft = file.resolveSibling(".badlog-${UUID.randomUUID()}.part")
        try {
            BufferedOutputStream(Files.newOutputStream(draft, CREATE_NEW, WRITE)).use(write)
            move(draft, file)
        } finally {
            Files.deleteIfExists(draft)
        }
    } catch (_: ClosedByInterruptException) {
        Thread.interrupted()
        throw InterruptedException()
    } catch (e: IOException) {
        if (e is InterruptedIOException) throw InterruptedException()
        throw IOException(sentence(file, e), e)
    }
}

private fun move(draft: Path, file: Path) {
    try {
        Files.move(draft, file, ATOMIC_MOVE)
    } catch (_: AtomicMoveNotSupportedException) {
        Files.move(draft, file, REPLACE_EXISTING)
    }
}

private fun sentence(file: Path, e: IOException): String = when (e) {
    is AccessDeniedException -> "$file cannot be written: you have no permission to; choose another folder."
    is NoSuchFileException -> "$file cannot be written: its folder is not there; choose another one."
    is FileSystemException -> "$file cannot be written (${e.reason ?: "for a reason the system does not tell"}); choose another folder."
    else -> "$file cannot be written (${e.message}); is the disk full? Choose another one."
}
