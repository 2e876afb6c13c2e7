package badlog.html

import badlog.file.UnreadableFileException
import badlog.file.requireRegularFile
import java.io.FilterInputStream
import java.io.IOException
import java.io.InputStream
import java.nio.channels.ClosedByInterruptException
import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path

/** A stream of [file] whose failures say that it is this file that cannot be read. */
internal class ReadGuard(private val file: Path, stream: InputStream) : FilterInputStream(stream) {
    override fun read(bytes: ByteArray, from: Int, size: Int): Int = reading(file) { super.read(bytes, from, size) }
}

/** Runs [work], which reads [file]; its failures become [ExportException.Unreadable]. */
internal fun <T> reading(file: Path, work: () -> T): T = refusing { badlog.file.reading(file, work) }

private fun <T> refusing(work: () -> T): T = try {
    work()
} catch (e: UnreadableFileException) {
    throw ExportException.Unreadable(e.file, e.message, e.cause)
}

/** Runs [work], which writes [page]; its failures become [ExportException.Unwritable]. */
public fun <T> writing(page: Path, work: () -> T): T = try {
    work()
} catch (e: ExportException) {
    throw e
} catch (_: ClosedByInterruptException) {
    Thread.interrupted()
    throw InterruptedException()
} catch (e: IOException) {
    val message = when {
        e is AccessDeniedException -> "$page cannot be written: you have no permission to; choose another folder."
        e is FileAlreadyExistsException -> "$page cannot be written: ${e.file} is a file, not a folder; choose another."
        e is DiskFullException -> "$page cannot be written: the disk is full; make room, or choose another disk."
        else -> "$page cannot be written (${e.message}); choose another place."
    }
    throw ExportException.Unwritable(page, message, e)
}

/** Looks before any work whether [file] is there and is a file. */
internal fun checkReadable(file: Path) = refusing { requireRegularFile(file) }

/** Looks before any work whether [page] may be written while [files] are read. */
internal fun checkWritable(page: Path, files: List<Path>) {
    if (Files.isDirectory(page)) {
        throw ExportException.Unwritable(page, "$page is a folder; give the page another name, or put it inside.")
    }
    if (Files.exists(page) && files.any { Files.isSameFile(it, page) }) {
        throw ExportException.Unwritable(page, "$page would overwrite a file that is read; give the page another name.")
    }
}
