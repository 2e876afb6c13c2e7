package badlog.report

import badlog.file.LogFile
import badlog.html.BADLOG_VERSION
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.builtins.ListSerializer
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.security.MessageDigest
import java.util.HexFormat
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * What came of a question to each of many files, kept in one file of [folder], which may be deleted at any time. What is damaged,
 * or of another version, is as nothing. A failure to write costs only time, so it is not reported. Safe for several threads.
 *
 * @param question what was asked, whatever changes the results; another question has another file, and so has another program.
 * @param pause how long [saveNowAndThen] waits from one time to the next.
 */
internal class ResultCache<R : Any>(
    private val folder: Path,
    question: String,
    results: KSerializer<R>,
    private val pause: Duration = DEFAULT_PAUSE,
) {
    private val file =
        folder.resolve("$PREFIX${HexFormat.of().formatHex(digest("$BADLOG_VERSION\n$VERSION\n$question"), 0, 16)}$SUFFIX")
    private val serializer = ListSerializer(Entry.serializer(results))
    private val known = LinkedHashMap<String, Entry<R>>()
    private var isChanged = false
    private var saved = TimeSource.Monotonic.markNow()

    @Serializable
    private class Entry<R>(val path: String, val size: Long, val modified: Long, val result: R)

    init {
        load()
    }

    /** What is known of [file] as it is now, or null. */
    @Synchronized
    operator fun get(file: LogFile): R? = known[keyOf(file)]?.takeIf { it.size == file.size && it.modified == file.modified }?.result

    @Synchronized
    operator fun set(file: LogFile, result: R) {
        val key = keyOf(file)
        // At the end, so that the oldest are first.
        known.remove(key)
        known[key] = Entry(key, file.size, file.modified, result)
        isChanged = true
    }

    /** Keeps everything for the next time, if it was not done lately. */
    @Synchronized
    fun saveNowAndThen() {
        if (saved.elapsedNow() >= pause) save()
    }

    /** Keeps everything for the next time. */
    @Synchronized
    fun save() {
        if (!isChanged) return
        // A file that an interrupted thread writes is closed at once.
        val wasInterrupted = Thread.interrupted()
        write()
        if (wasInterrupted) Thread.currentThread().interrupt()
        isChanged = false
        saved = TimeSource.Monotonic.markNow()
    }

    private fun write() {
        while (known.size > MAX_FILES) known.remove(known.keys.first())
        try {
            Files.createDirectories(folder)
            val body = JSON.encodeToString(serializer, known.values.toList()).encodeToByteArray()
            val draft = Files.createTempFile(folder, PREFIX, ".draft")
            try {
                Files.newOutputStream(draft).use {
                    it.write(digest(body))
                    it.write(body)
                }
                Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING)
            } finally {
                Files.deleteIfExists(draft)
            }
            dropOldest()
        } catch (_: IOException) {
            return
        } catch (_: OutOfMemoryError) {
            // The logs under way have it all; there is a next time.
            return
        }
    }

    private fun load() {
        try {
            if (Files.notExists(file) || Files.size(file) > MAX_BYTES) return
            val bytes = Files.readAllBytes(file)
            if (bytes.size < DIGEST) return
            val body = bytes.copyOfRange(DIGEST, bytes.size)
            if (!digest(body).contentEquals(bytes.copyOf(DIGEST))) return
            for (entry in JSON.decodeFromString(serializer, body.decodeToString())) known[entry.path] = entry
        } catch (_: IOException) {
            known.clear()
        } catch (_: SerializationException) {
            known.clear()
        }
    }

    /** So that not every question ever asked stays. */
    private fun dropOldest() {
        val files = Files.newDirectoryStream(folder, "$PREFIX*$SUFFIX").use { it.toList() }
        files.sortedByDescending { Files.getLastModifiedTime(it) }.drop(MAX_QUESTIONS).forEach(Files::deleteIfExists)
    }

    private companion object {
        /** To be raised when the same file and question may come to something else than before. */
        const val VERSION = 10
        val DEFAULT_PAUSE = 10.seconds
        const val PREFIX = "report-"
        const val SUFFIX = ".cache"
        const val DIGEST = 32
        const val MAX_FILES = 20_000
        const val MAX_BYTES = 1L shl 28
        const val MAX_QUESTIONS = 100
        val JSON = Json { allowSpecialFloatingPointValues = true }

        fun keyOf(file: LogFile) = file.path.toAbsolutePath().normalize().toString()

        fun digest(text: String) = digest(text.encodeToByteArray())

        fun digest(bytes: ByteArray): ByteArray = MessageDigest.getInstance("SHA-256").digest(bytes)
    }
}
