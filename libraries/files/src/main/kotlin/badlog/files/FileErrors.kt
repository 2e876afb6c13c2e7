package badlog.files

import java.io.IOException
import java.io.InterruptedIOException
import java.nio.channels.ClosedByInterruptException
import java.nio.file.AccessDeniedException
import java.nio.file.DirectoryIteratorException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/**
 * Thrown if a file or a folder cannot be read. The message is one sentence for the user: what, where, and what to do.
 *
 * @property file the file or folder.
 */
public open class UnreadableFileException(public val file: Path, override val message: String, cause: Throwable? = null) :
    IOException(message, cause)

/** Thrown if a file does not fit into memory. */
public class TooLargeFileException internal constructor(file: Path, message: String, cause: Throwable) :
    UnreadableFileException(file, message, cause)

/**
 * Thrown if a file cannot be written. The message is one sentence for the user: what, where, and what to do.
 *
 * @property file the file.
 */
public class UnwritableFileException(public val file: Path, override val message: String, cause: Throwable? = null) :
    IOException(message, cause)

/**
 * Runs [work], which reads [file], a file or a folder.
 *
 * @throws UnreadableFileException if [work] throws an [IOException], also while a folder is listed.
 * @throws InterruptedException if the thread was interrupted while reading.
 */
public fun <T> reading(file: Path, work: () -> T): T = try {
    work()
} catch (_: ClosedByInterruptException) {
    Thread.interrupted()
    throw InterruptedException()
} catch (e: DirectoryIteratorException) {
    throw unreadable(file, e.cause ?: e)
} catch (e: IOException) {
    throw unreadable(file, e)
}

/** Returns the error of reading [file], a file or a folder, caused by [e]. */
public fun unreadable(file: Path, e: Throwable): UnreadableFileException {
    val message = when (e) {
        is NoSuchFileException -> missingSentence("$file")

        is AccessDeniedException -> {
            val remedy = if (Files.isDirectory(file)) "change its permissions" else "copy it"
            "$file cannot be read: permission denied; $remedy, or ask its owner."
        }

        else -> "$file cannot be read (${e.message}); copy it to this computer's disk first."
    }
    return UnreadableFileException(file, message, e)
}

/** Returns the message, a sentence, that nothing exists at [path]. */
public fun missingSentence(path: String): String = "There is no file or folder $path; check the spelling."

/** The sentence for users who named a place without logs. */
public const val NO_LOGS_SENTENCE: String = "No logs found. Name a log, or the folder it is in."

/**
 * Checks that [folder] exists and is a folder.
 *
 * @throws UnreadableFileException if it is not.
 */
public fun requireFolder(folder: Path) {
    reading(folder) { folder.toRealPath() }
    if (!Files.isDirectory(folder)) throw UnreadableFileException(folder, "$folder is a file, not a folder; name the folder that it is in.")
}

/**
 * Checks that [file] exists and is a regular file, which can be opened without waiting for another program.
 *
 * @throws UnreadableFileException if it is not.
 */
public fun requireRegularFile(file: Path) {
    if (Files.isDirectory(file)) throw UnreadableFileException(file, "$file is a folder, not a file; name a file in it.")
    reading(file) { file.toRealPath() }
    if (!Files.isRegularFile(file)) {
        throw UnreadableFileException(file, "$file is not a regular file; copy its content into a file first.")
    }
}

/**
 * Checks, before any work, that [target] can be written. It must not be a folder, nor one of the files that are read.
 *
 * @param advice the remedy to name if it cannot be written; null for the usual one, for users who choose the file itself.
 * @param isRead returns whether an existing file is one of the files that are read.
 * @throws UnwritableFileException if it is a folder, or one of the files that are read.
 */
public fun requireTarget(target: Path, advice: String? = null, isRead: (Path) -> Boolean = { false }) {
    if (Files.isDirectory(target)) {
        throw UnwritableFileException(target, "$target is a folder; ${advice ?: "name another file, or one inside it"}.")
    }
    if (Files.exists(target) && isRead(target)) {
        throw UnwritableFileException(target, "$target would overwrite a file that is read; ${advice ?: "select another name"}.")
    }
}

/**
 * Runs [work], which writes [file].
 *
 * @throws UnwritableFileException if [work] throws an [IOException].
 * @throws InterruptedException if the thread was interrupted while writing.
 */
public fun <T> writing(file: Path, work: () -> T): T = try {
    work()
} catch (_: ClosedByInterruptException) {
    Thread.interrupted()
    throw InterruptedException()
} catch (_: InterruptedIOException) {
    throw InterruptedException()
} catch (e: UnreadableFileException) {
    throw e
} catch (e: UnwritableFileException) {
    throw e
} catch (e: IOException) {
    throw unwritable(file, e)
}

/** Returns the error of writing [file], a file or a folder, caused by [e]. */
public fun unwritable(file: Path, e: IOException): UnwritableFileException {
    val message = when (e) {
        is AccessDeniedException -> if (isReplaceable(file)) {
            "$file cannot be replaced: it is read-only, or another program has it open; make it writable, or close it there."
        } else {
            "$file cannot be written: permission denied; change the permissions of its folder."
        }

        is FileAlreadyExistsException -> "$file cannot be written: ${e.file} is a file, not a folder; rename that file."

        is NoSuchFileException -> "$file cannot be written: its folder does not exist; create it."

        is DiskFullException -> "$file cannot be written: the disk is full; make room, or select another disk."

        is FileSystemException -> "$file cannot be written (${e.reason ?: e.message}); select another place."

        else -> "$file cannot be written (${e.message}); select another place."
    }
    return UnwritableFileException(file, message, e)
}

// Windows refuses to replace such files, and does not say why.
private fun isReplaceable(file: Path) = Files.isRegularFile(file) && file.toAbsolutePath().parent?.let(Files::isWritable) == true
