package badlog.file

import java.io.IOException
import java.nio.channels.ClosedByInterruptException
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/**
 * Runs [work], which reads [file], a file or a folder.
 *
 * @throws UnreadableFileException for an [IOException] of [work].
 * @throws InterruptedException when the thread was interrupted while it read.
 */
public fun <T> reading(file: Path, work: () -> T): T = try {
    work()
} catch (_: ClosedByInterruptException) {
    Thread.interrupted()
    throw InterruptedException()
} catch (e: IOException) {
    val message = when (e) {
        is NoSuchFileException -> "There is no file $file; look for a typing error in its name."
        is AccessDeniedException -> "$file cannot be read: you have no permission to; copy it, or ask its owner."
        else -> "$file cannot be read (${e.message}); try to copy it to this computer's disk first."
    }
    throw UnreadableFileException(file, message, e)
}

/**
 * Looks whether [file] is there and is a regular file, which can be opened without waiting for another program.
 *
 * @throws UnreadableFileException when it is not.
 */
public fun requireRegularFile(file: Path) {
    if (Files.isDirectory(file)) throw UnreadableFileException(file, "$file is a folder, where a file is expected.")
    reading(file) { file.toRealPath() }
    if (!Files.isRegularFile(file)) {
        throw UnreadableFileException(file, "$file is no ordinary file; copy what it holds into a file first.")
    }
}
