package badlog.fetch

import badlog.files.reading
import badlog.files.safeName
import badlog.files.writing
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.nio.file.attribute.FileTime
import java.security.MessageDigest
import java.time.Duration
import java.time.Instant
import java.util.HexFormat
import kotlin.math.min

/** Thrown if a log shrank on the robot while it was copied. */
internal class ShrunkLogException : Exception()

/**
 * Copies logs into hidden parts in [folder], which become logs only once they are complete. An existing part is continued.
 *
 * @param limit limits the transfer rate.
 * @param room returns the free bytes on the disk of a folder.
 * @param write writes all of the bytes.
 * @param checkpoint called for each piece; may throw to cancel.
 */
internal class LogCopy(
    private val folder: Path,
    private val limit: BandwidthLimit,
    private val room: (Path) -> Long = { Files.getFileStore(it).usableSpace },
    private val write: (FileChannel, ByteBuffer) -> Unit = { file, bytes -> while (bytes.hasRemaining()) file.write(bytes) },
    private val checkpoint: () -> Unit,
) {
    /** A part with all bytes of its log; the first [from] bytes were here before. */
    class Whole(val part: Path, val from: Long)

    /**
     * Copies all of [log], up to its size when it was listed.
     *
     * @param former an older copy of it, which may be its beginning; or null.
     * @param progress called with the number of bytes copied.
     * @throws IOException if the connection is lost; the copied part is kept.
     * @throws NoRoomException if there is not enough room, or the disk becomes full meanwhile; the copied part is kept.
     * @throws ShrunkLogException if the log no longer has that many bytes.
     */
    fun copy(connection: RobotConnection, log: RemoteLog, former: Path?, progress: (Long) -> Unit): Whole {
        val part = partOf(connection.robot, log)
        val from = begin(connection, log, part, former)
        val left = room(folder)
        if (log.size - from > left) {
            throw NoRoomException(
                "${safeName(log.name)} needs ${(log.size - from) / MEGA + 1} MB, and the disk of $folder has ${left / MEGA} MB left; " +
                    "make room, or select another disk.",
            )
        }
        progress(from)
        writing(part) { FileChannel.open(part, CREATE, WRITE, APPEND) }.use { file ->
            append(connection, log, from, progress) { bytes, size ->
                filling(log, part, size) { write(file, ByteBuffer.wrap(bytes, 0, size)) }
            }
            // Needed before the log may be removed from the robot.
            filling(log, part, 1) { file.force(true) }
        }
        return Whole(part, from)
    }

    /** Runs [work], which writes [bytes] of [log] to [part]. */
    private fun filling(log: RemoteLog, part: Path, bytes: Int, work: () -> Unit) = writing(part) {
        try {
            work()
        } catch (e: IOException) {
            // The system's message differs by platform and language, so the remaining room is checked.
            if (RobotConnection.isInterruption(e) || room(folder) >= bytes) throw e
            throw NoRoomException(
                "The disk of $folder is full, so ${safeName(
                    log.name,
                )} is only partly here; make room, then fetch again to resume.",
            )
        }
    }

    private fun append(connection: RobotConnection, log: RemoteLog, from: Long, progress: (Long) -> Unit, write: (ByteArray, Int) -> Unit) {
        if (from == log.size) return
        val bytes = ByteArray(PIECE)
        var done = from
        val stream = connection.read(log, from)
        while (done < log.size) {
            checkpoint()
            val size = RobotConnection.talking { stream.read(bytes, 0, min(bytes.size.toLong(), log.size - done).toInt()) }
            if (size < 0) throw ShrunkLogException()
            write(bytes, size)
            done += size
            progress(done)
            limit.spend(size)
        }
        // Only here, because closing it waits for all requested data, even after cancelling.
        RobotConnection.talking { stream.close() }
    }

    /** Returns how many bytes of [log] are already in [part], which is recreated if it has other bytes. */
    private fun begin(connection: RobotConnection, log: RemoteLog, part: Path, former: Path?): Long {
        val held = if (Files.exists(part)) Files.size(part) else 0
        if (held in 1..log.size && isBeginning(connection, log, part)) return held
        writing(part) { Files.deleteIfExists(part) }
        val size = former?.takeIf(Files::isRegularFile)?.let(Files::size) ?: 0
        if (former == null || size !in 1..log.size || !isBeginning(connection, log, former)) return 0
        if (size > room(folder)) return 0
        writing(part) { Files.copy(former, part) }
        return Files.size(part)
    }

    /** Returns whether [log] begins with [file], judged by the two ends of [file], where a rewritten log differs. */
    private fun isBeginning(connection: RobotConnection, log: RemoteLog, file: Path): Boolean {
        val size = Files.size(file)
        val ends = listOf(0L, maxOf(size - LOOK, 0)).distinct()
        return reading(file) { FileChannel.open(file) }.use { channel ->
            ends.all { from ->
                val here = ByteBuffer.allocate(min(LOOK.toLong(), size - from).toInt())
                while (here.hasRemaining()) if (channel.read(here, from + here.position()) < 0) return false
                connection.piece(log, from, here.capacity()).contentEquals(here.array())
            }
        }
    }

    /**
     * Returns the parts that will never be complete. They belong to logs of [robot] that are not among [logs], and have not grown for a
     * day. They are kept for a day because a robot's USB stick may be removed for a while.
     */
    fun leftParts(robot: String, logs: List<RemoteLog>): List<Path> {
        val wanted = logs.mapTo(HashSet()) { partOf(robot, it) }
        val latest = FileTime.from(Instant.now().minus(LEFT_AFTER))
        return Files.newDirectoryStream(folder, "${startOf(robot)}*.part").use { parts ->
            parts.filter { it !in wanted && Files.getLastModifiedTime(it) < latest }
        }
    }

    private fun partOf(robot: String, log: RemoteLog): Path = folder.resolve("${startOf(robot)}${digestOf(log.path)}.part")

    private fun startOf(robot: String) = ".badlog-fetch-${digestOf(robot)}-"

    private fun digestOf(text: String) =
        HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text.encodeToByteArray()), 0, DIGEST)

    private companion object {
        const val PIECE = 1 shl 16
        const val LOOK = 1 shl 14
        const val DIGEST = 8
        val LEFT_AFTER: Duration = Duration.ofDays(1)
        const val MEGA = 1_000_000
    }
}
