package badlog.fetch

import badlog.file.writing
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlinx.serialization.json.long
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.security.MessageDigest
import java.util.HexFormat

/**
 * A log that was fetched.
 *
 * @property robot which robot it is from.
 * @property path where it is on the robot.
 * @property size its bytes there when it was fetched.
 * @property modified when it was written last, as the robot said.
 * @property file where it went, seen from the folder of fetched logs.
 * @property digest what its bytes are known by.
 * @property fetched when, in milliseconds since 1970.
 */
internal class LogHere(
    val robot: String,
    val path: String,
    val size: Long,
    val modified: Long,
    val file: String,
    val digest: String,
    val fetched: Long,
)

/**
 * Which logs were fetched into [folder], in a hidden file there: a line of JSON for each, the last one counts. One program at a time has
 * it. To be closed.
 */
internal class FetchedLogs private constructor(private val folder: Path, private val channel: FileChannel) : AutoCloseable {
    private val logs = HashMap<Pair<String, String>, LogHere>()

    init {
        val text = String(Files.readAllBytes(folder.resolve(NAME)), Charsets.UTF_8)
        for (line in text.lineSequence()) entryOf(line)?.let { logs[it.robot to it.path] = it }
        // A power cut left half a line.
        if (text.isNotEmpty() && !text.endsWith('\n')) append("\n")
    }

    /** The log of [robot] at [path] as it was fetched last, or null. */
    fun find(robot: String, path: String): LogHere? = logs[robot to path]

    /** Where [log] is on this computer. */
    fun fileOf(log: LogHere): Path = folder.resolve(log.file)

    /** Whether [log] is still on this computer with the bytes that were fetched. */
    fun isSafe(log: LogHere): Boolean {
        val file = fileOf(log)
        return Files.isRegularFile(file) && Files.size(file) == log.size && digestOf(file) == log.digest
    }

    /** [log] was fetched. */
    fun add(log: LogHere) {
        logs[log.robot to log.path] = log
        append(lineOf(log) + "\n")
    }

    override fun close() = channel.close()

    private fun append(text: String) = writing(folder.resolve(NAME)) {
        val bytes = ByteBuffer.wrap(text.encodeToByteArray())
        while (bytes.hasRemaining()) channel.write(bytes)
    }

    companion object {
        private const val NAME = ".badlog-fetched.jsonl"

        /**
         * What was fetched into [folder], which is made if need be.
         *
         * @throws NoRoomException while another program fetches into it.
         * @throws badlog.file.UnwritableFileException when it cannot be written to.
         */
        fun open(folder: Path): FetchedLogs = writing(folder) {
            Files.createDirectories(folder)
            val channel = FileChannel.open(folder.resolve(NAME), CREATE, WRITE, APPEND)
            val lock = try {
                channel.tryLock(Long.MAX_VALUE - 1, 1, false)
            } catch (_: OverlappingFileLockException) {
                null
            }
            if (lock == null) {
                channel.close()
                throw NoRoomException("Another badlog is fetching into $folder; wait until it is done, or select another folder.")
            }
            FetchedLogs(folder, channel)
        }

        /** What the bytes of [file] are known by: SHA-256. */
        fun digestOf(file: Path): String {
            val digest = MessageDigest.getInstance("SHA-256")
            Files.newInputStream(file).use { stream ->
                val bytes = ByteArray(1 shl 16)
                while (true) {
                    val size = stream.read(bytes)
                    if (size < 0) break
                    digest.update(bytes, 0, size)
                }
            }
            return HexFormat.of().formatHex(digest.digest())
        }

        private fun lineOf(log: LogHere) = JsonObject(
            mapOf(
                "robot" to JsonPrimitive(log.robot),
                "path" to JsonPrimitive(log.path),
                "size" to JsonPrimitive(log.size),
                "modified" to JsonPrimitive(log.modified),
                "file" to JsonPrimitive(log.file),
                "sha256" to JsonPrimitive(log.digest),
                "fetched" to JsonPrimitive(log.fetched),
            ),
        ).toString()

        /** Null for a line that is damaged. */
        private fun entryOf(line: String): LogHere? = try {
            val json = Json.parseToJsonElement(line).jsonObject
            fun text(name: String) = json.getValue(name).jsonPrimitive.content
            fun number(name: String) = json.getValue(name).jsonPrimitive.long
            LogHere(text("robot"), text("path"), number("size"), number("modified"), text("file"), text("sha256"), number("fetched"))
        } catch (_: IllegalArgumentException) {
            null
        } catch (_: NoSuchElementException) {
            null
        }
    }
}
