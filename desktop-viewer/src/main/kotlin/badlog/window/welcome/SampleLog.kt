package badlog.window.welcome

import badlog.files.UnwritableFileException
import badlog.files.writeAtomically
import java.nio.file.Files
import java.nio.file.Path

/** The log of a match that comes with the window, for a person who has no log yet. */
internal object SampleLog {
    /**
     * Unpacks the log into the folder [cache], or a temporary one if [cache] cannot be written, and returns its file.
     *
     * @throws java.io.IOException if neither can be written.
     */
    fun unpack(cache: Path): Path = try {
        unpackInto(cache)
    } catch (_: UnwritableFileException) {
        unpackInto(Files.createTempDirectory("badlog"))
    }

    /**
     * Unpacks the log into the folder [cache], unless it is there, and returns its file.
     *
     * @throws java.io.IOException with a sentence for a person, if it cannot be written.
     */
    fun unpackInto(cache: Path): Path {
        val packed =
            checkNotNull(SampleLog::class.java.getResourceAsStream(NAME)) { "The program lacks its file “$NAME”; install it again." }
        val bytes = packed.use { it.readAllBytes() }
        val file = cache.resolve("samples").resolve(NAME)
        if (!Files.exists(file) || Files.size(file) != bytes.size.toLong()) writeAtomically(file) { it.write(bytes) }
        return file
    }

    private const val NAME = "qualification-42.bag.gz"
}
