package badlog.viewer.library.index

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.security.MessageDigest
import java.util.HexFormat

/**
 * Keeps what is known of the logs of [folder], so that they need not be read again: in one file of [cache], which may be
 * deleted at any time. What is damaged, or of another version, is as nothing.
 */
internal class IndexCache(private val cache: Path, folder: Path) {
    private val file = cache.resolve("logs-${nameOf(folder)}.index")

    /** What was kept. */
    fun load(): List<LogEntry> = try {
        IndexFormat.decode(Files.readAllBytes(file)).orEmpty()
    } catch (_: IOException) {
        emptyList()
    } catch (_: OutOfMemoryError) {
        emptyList()
    }

    /**
     * Keeps [entries] instead of what was kept, which a crash leaves as it was.
     *
     * @throws IOException when they cannot be written.
     */
    fun save(entries: Collection<LogEntry>) {
        Files.createDirectories(cache)
        val draft = Files.createTempFile(cache, "logs-", ".draft")
        try {
            Files.write(draft, IndexFormat.encode(entries))
            Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(draft)
        }
    }

    private companion object {
        fun nameOf(folder: Path): String {
            val digest = MessageDigest.getInstance("SHA-256").digest(folder.toString().encodeToByteArray())
            return HexFormat.of().formatHex(digest, 0, 12)
        }
    }
}
