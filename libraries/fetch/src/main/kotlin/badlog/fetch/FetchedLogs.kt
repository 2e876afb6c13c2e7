package badlog.fetch

import badlog.files.writing
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
 * @property robot the robot's key, see [RobotConnection.robot].
 * @property path its path on the robot.
 * @property size its size in bytes there when it was fetched.
 * @property modified the time when it was last written, in seconds since 1970 by the robot's clock.
 * @property file its path relative to the folder of fetched logs.
 * @property digest the SHA-256 digest of its bytes, in hexadecimal digits.
 * @property fetched when it was fetched, in milliseconds since 1970.
 */
internal class CopiedLog(
    val robot: String,
    val path: String,
    val size: Long,
    val modified: Long,
    val file: String,
    val digest: String,
    val fetched: Long,
)

/**
 * The list of logs fetched into [folder], in a hidden file there. Each fetched log adds a line of JSON; the last line about a log counts.
 * Only one program can open it at a time. Must be closed.
 */
internal class FetchedLogs private constructor(private val folder: Path, private val channel: FileChannel) : AutoCloseable {
    private val logs = HashMap<Pair<String, String>, CopiedLog>()

    init {
        val text = String(Files.readAllBytes(folder.resolve(NAME)), Charsets.UTF_8)
        for (line in text.lineSequence()) entryOf(line)?.let { logs[it.robot to it.path] = it }
        // The last line may be incomplete after a loss of power.
        if (text.isNotEmpty() && !text.endsWith('\n')) append("\n")
    }

    /** Returns the log of [robot] at [path] as last fetched, or null. */
    fun find(robot: String, path: String): CopiedLog? = logs[robot to path]

    /** Returns the path of [log] on this computer. */
    fun fileOf(log: CopiedLog): Path = folder.resolve(log.file)

    /** Returns whether [log] is still on this computer with the bytes that were fetched. */
    fun isSafe(log: CopiedLog): Boolean {
        val file = fileOf(log)
        return Files.isRegularFile(file) && Files.size(file) == log.size && digestOf(file) == log.digest
    }

    /** Records that [log] was fetched. */
    fun add(log: CopiedLog) {
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
         * Opens the logs fetched into [folder], which is created if necessary.
         *
         * @throws NoRoomException while another program fetches into it.
         * @throws badlog.files.UnwritableFileException if it cannot be written to.
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

        /** Returns the SHA-256 digest of the bytes of [file]. */
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

        private fun lineOf(log: CopiedLog) = JsonObject(
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

        /** Returns null for a damaged line. */
        private fun entryOf(line: String): CopiedLog? = try {
            val json = Json.parseToJsonElement(line).jsonObject
            fun text(name: String) = json.getValue(name).jsonPrimitive.content
            fun number(name: String) = json.getValue(name).jsonPrimitive.long
            CopiedLog(text("robot"), text("path"), number("size"), number("modified"), text("file"), text("sha256"), number("fetched"))
        } catch (_: IllegalArgumentException) {
            null
        } catch (_: NoSuchElementException) {
            null
        }
    }
}
