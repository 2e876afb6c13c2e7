package badlog.viewer.layout

import badlog.viewer.settings.keyOf
import java.io.IOException
import java.nio.file.Path

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

    private fun fileOf(folder: Path): Path = place.resolve("${keyOf(folder)}.json")
}
