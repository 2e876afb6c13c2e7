package badlog.exporter

import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import badlog.files.requireRegularFile
import badlog.files.requireTarget
import java.io.FilterInputStream
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path

/** A stream that reads [file]; its exceptions report that this file is unreadable. */
internal class ReadGuard(private val file: Path, stream: InputStream) : FilterInputStream(stream) {
    override fun read(bytes: ByteArray, from: Int, size: Int): Int = reading(file) { super.read(bytes, from, size) }
}

/** Runs [work], which reads [file]; its failures become [ExportException.Unreadable]. */
internal fun <T> reading(file: Path, work: () -> T): T = refusing { badlog.files.reading(file, work) }

/** Runs [work]; if it cannot read or write a file, throws an [ExportException]. */
internal fun <T> refusing(work: () -> T): T = try {
    work()
} catch (e: UnreadableFileException) {
    throw ExportException.Unreadable(e.file, e.message, e.cause)
} catch (e: UnwritableFileException) {
    throw ExportException.Unwritable(e.file, e.message, e.cause)
}

/** Runs [work], which writes [page]; its failures become [ExportException.Unwritable]. */
internal fun <T> writing(page: Path, work: () -> T): T = try {
    work()
} catch (e: ExportException) {
    throw e
} catch (e: IOException) {
    refusing { badlog.files.writing(page) { throw e } }
}

/** Checks, before any work, that [file] exists and is a file. */
internal fun checkReadable(file: Path) = refusing { requireRegularFile(file) }

/** Checks, before any work, that [page] can be written while [files] are read. */
internal fun checkWritable(page: Path, files: List<Path>) =
    refusing { requireTarget(page) { target -> files.any { Files.isSameFile(it, target) } } }
