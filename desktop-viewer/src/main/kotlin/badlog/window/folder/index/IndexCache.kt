package badlog.window.folder.index

import badlog.files.writeAtomically
import badlog.rules.FolderRules
import badlog.rules.SignalsFile
import badlog.signals.vocabulary.toJson
import badlog.window.settings.keyOf
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Stores what is known about the logs of [folder], so that they need not be read again: in one file in [cache], which may be
 * deleted at any time. A file that is damaged, of another version, or made with different names of signals is ignored.
 */
internal class IndexCache(cache: Path, folder: Path) {
    private val file = cache.resolve("logs-${keyOf(folder)}.index")
    private val names by lazy { FolderRules.of(folder.resolve(SignalsFile.NAME)).rules.signals.toJson().hashCode() }

    /** Returns what was stored. */
    fun load(): List<LogEntry> = try {
        IndexFormat.decode(Files.readAllBytes(file), names).orEmpty()
    } catch (_: IOException) {
        emptyList()
    } catch (_: OutOfMemoryError) {
        emptyList()
    }

    /**
     * Stores [entries] atomically, replacing what was stored.
     *
     * @throws IOException if they cannot be written.
     */
    fun save(entries: Collection<LogEntry>) {
        val bytes = IndexFormat.encode(entries, names)
        writeAtomically(file) { it.write(bytes) }
    }
}
