package badlog.window.layout

import badlog.files.locking
import java.io.IOException
import java.nio.file.Path
import java.security.MessageDigest
import java.util.HexFormat

/** The last layouts of folders, in the user's own files below [place]. Use it off the window's thread. */
internal class FolderLayouts(private val place: Path) {
    /** Returns the layout for [folder]; null if there is none, or it is damaged. */
    fun read(folder: Path): Layout? = try {
        readLayout(fileOf(folder))
    } catch (_: IOException) {
        null
    }

    /**
     * Stores the result of [change] for [folder]; [change] receives the stored layout. Other windows store nothing in between.
     *
     * @throws IOException with a sentence for the user, if it cannot be written.
     */
    fun update(folder: Path, change: (Layout?) -> Layout): Unit = locking(place) { writeLayout(fileOf(folder), change(read(folder))) }

    /** Returns the time of the last change to the layout of [folder], in milliseconds since 1970. 0 if there is none. */
    fun writtenAt(folder: Path): Long = fileOf(folder).toFile().lastModified()

    private fun fileOf(folder: Path): Path = place.resolve("${keyOf(folder)}.json")
}

/** Returns a name for a file with data about [folder]. The folder's path may be too long for a file name. */
internal fun keyOf(folder: Path): String {
    val path = folder.toAbsolutePath().normalize().toString()
    val digest = MessageDigest.getInstance("SHA-256").digest(path.encodeToByteArray())
    return HexFormat.of().formatHex(digest, 0, BYTES)
}

private const val BYTES = 16
