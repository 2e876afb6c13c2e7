package badlog.catalog.store

import badlog.files.LogFile
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.protobuf.ProtoBuf
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.util.zip.CRC32
import java.util.zip.Deflater
import java.util.zip.GZIPInputStream
import java.util.zip.GZIPOutputStream
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/** A result for a file; [isLasting] says whether it stays valid until the file changes. */
class CachedResult<out R>(val result: R, val isLasting: Boolean)

/**
 * The results of a question for many files, stored in one file in [folder]. The file may be deleted at any time. A damaged file, or one of
 * another version, is ignored. A failure to write only costs time, so it is not reported. Thread-safe.
 *
 * @param question the question, with everything that affects the results, including the program's version; each question has a file of its
 *   own.
 * @param pause the time that [saveNowAndThen] waits between saves.
 */
@OptIn(ExperimentalSerializationApi::class)
class ResultCache<R : Any>(
    private val folder: Path,
    question: String,
    results: KSerializer<R>,
    private val pause: Duration = DEFAULT_PAUSE,
) {
    private val asked = "$VERSION\n$question"
    private val file = asked.encodeToByteArray().let { folder.resolve("$PREFIX${checkOf(it).toString(HEX)}-${it.size}$SUFFIX") }
    private val serializer = StoredResults.serializer(results)
    private val known = LinkedHashMap<String, Entry<R>>()

    /** The results found by this program; another program may have updated the others meanwhile. */
    private val own = HashSet<String>()
    private var isChanged = false
    private var saved = TimeSource.Monotonic.markNow()

    @Serializable
    private class Entry<R>(val path: String, val size: Long, val modified: Long, val result: R)

    // Two questions may have files with the same name.
    @Serializable
    private class StoredResults<R>(val asked: String, val entries: List<Entry<R>>)

    /** Fast, because all results of a folder are written every few seconds while it is read. */
    private class FastGzip(out: OutputStream) : GZIPOutputStream(out) {
        init {
            def.setLevel(Deflater.BEST_SPEED)
        }
    }

    init {
        addStored()
    }

    /** Returns the cached result for [file] in its current state, or null. */
    @Synchronized
    operator fun get(file: LogFile): R? = known[keyOf(file)]?.takeIf { it.size == file.size && it.modified == file.modified }?.result

    @Synchronized
    operator fun set(file: LogFile, result: R) {
        val key = keyOf(file)
        // Moved to the end, so that the oldest are first.
        known.remove(key)
        known[key] = Entry(key, file.size, file.modified, result)
        own += key
        isChanged = true
    }

    /** Saves everything, unless that was done recently. */
    @Synchronized
    fun saveNowAndThen() {
        if (saved.elapsedNow() >= pause) save()
    }

    @Synchronized
    fun save() {
        if (!isChanged) return
        // A file that an interrupted thread writes is closed at once.
        val wasInterrupted = Thread.interrupted()
        isChanged = !write()
        if (wasInterrupted) Thread.currentThread().interrupt()
        saved = TimeSource.Monotonic.markNow()
    }

    /** Returns false if it failed: another program may have the file open just now. */
    private fun write(): Boolean {
        addStored()
        while (known.size > MAX_FILES) known.remove(known.keys.first())
        try {
            Files.createDirectories(folder)
            val body = ProtoBuf.encodeToByteArray(serializer, StoredResults(asked, known.values.toList()))
            val draft = Files.createTempFile(folder, PREFIX, ".draft")
            try {
                FastGzip(Files.newOutputStream(draft)).use { it.write(body) }
                Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING)
            } finally {
                Files.deleteIfExists(draft)
            }
            dropOldest()
            return true
        } catch (_: IOException) {
            return false
        } catch (_: OutOfMemoryError) {
            // Nothing is lost: the logs can be read again next time.
            return false
        }
    }

    private fun addStored() {
        val stored = try {
            read()
        } catch (_: IOException) {
            return
        } catch (_: RuntimeException) {
            // Another badlog of the same version wrote it.
            return
        }
        for (entry in stored) if (entry.path !in own) known[entry.path] = entry
    }

    private fun read(): List<Entry<R>> {
        if (Files.notExists(file)) return emptyList()
        val bytes = GZIPInputStream(Files.newInputStream(file)).use { it.readNBytes(MAX_BYTES + 1) }
        if (bytes.size > MAX_BYTES) return emptyList()
        val kept = ProtoBuf.decodeFromByteArray(serializer, bytes)
        return if (kept.asked == asked) kept.entries else emptyList()
    }

    /** Limits the number of stored questions. */
    private fun dropOldest() {
        val files = Files.newDirectoryStream(folder, "$PREFIX*$SUFFIX").use { it.toList() }
        files.sortedByDescending { Files.getLastModifiedTime(it) }.drop(MAX_QUESTIONS).forEach(Files::deleteIfExists)
    }

    private companion object {
        /** The version of the stored results. Increase it when the same file and question may now give a different result. */
        const val VERSION = 22
        val DEFAULT_PAUSE = 10.seconds
        const val PREFIX = "report-"
        const val SUFFIX = ".cache"
        const val HEX = 16
        const val MAX_FILES = 20_000
        const val MAX_BYTES = 1 shl 28
        const val MAX_QUESTIONS = 100
        fun keyOf(file: LogFile) = file.path.toAbsolutePath().normalize().toString()

        fun checkOf(bytes: ByteArray): Long = CRC32().apply { update(bytes) }.value
    }
}
