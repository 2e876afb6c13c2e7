package badlog.viewer.layout

import java.io.IOException
import java.nio.file.Path
import java.security.MessageDigest

/** The layouts of folders as they were left, in files of the user's own below [place]. */
internal class FolderLayouts(private val place: Path) {
    /** How the window was arranged over [folder]; null where it never was, or that is damaged. */
    fun read(folder: Path): Layout? = try {
        readLayout(fileOf(folder))
    } catch (_: IOException) {
        null
    }

    /**
     * Keeps [layout] for [folder].
     *
     * @throws IOException with a sentence for the person, when it cannot be written.
     */
    fun write(folder: Path, layout: Layout) = writeLayout(fileOf(folder), layout)

    // A folder's path may be longer than a file's name can be.
    private fun fileOf(folder: Path): Path {
        val path = folder.toAbsolutePath().normalize().toString()
        val digest = MessageDigest.getInstance("SHA-256").digest(path.encodeToByteArray())
        return place.resolve("${digest.take(NAME_BYTES).joinToString("") { "%02x".format(it) }}.json")
    }

    private companion object {
        const val NAME_BYTES = 16
    }
}
