package badlog.html

import java.io.FilterOutputStream
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/** There was no room on the disk for what was to be written. */
internal class DiskFullException(cause: IOException) : IOException(cause)

/** A stream of [file] whose failures tell a full disk from other reasons. */
internal class RoomGuard(private val file: Path, stream: OutputStream) : FilterOutputStream(stream) {
    override fun write(bytes: ByteArray, from: Int, size: Int) = try {
        out.write(bytes, from, size)
    } catch (e: IOException) {
        // The system's own words for it differ by platform and language; the room that is left does not.
        throw if (Files.getFileStore(file).usableSpace < size) DiskFullException(e) else e
    }
}
