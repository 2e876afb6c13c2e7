package badlog.fetch

import badlog.file.reading
import badlog.file.writing
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

/** A log shrank on the robot while it was copied. */
internal class ShrunkLogException : Exception()

/**
 * Copies logs into hidden parts in [folder], which only become logs when they are whole. A part that is there is gone on with.
 *
 * @param limit lets no more bytes pass than are wanted.
 * @param room how many bytes the disk of a folder has left.
 * @param write writes all of the bytes.
 * @param checkpoint is called for each piece, and may throw to give up.
 */
internal class LogCopy(
    private val folder: Path,
    private val limit: BandwidthLimit,
    private val room: (Path) -> Long = { Files.getFileStore(it).usableSpace },
    private val write: (FileChannel, ByteBuffer) -> Unit = { file, bytes -> while (bytes.hasRemaining()) file.write(bytes) },
    private val checkpoint: () -> Unit,
) {
    /** A part with all bytes of its log; [from] of them were here before. */
    class Whole(val part: Path, val from: Long)

    /**
     * Copies all of [log], as far as it had been written when it was looked at.
     *
     * @param former an older copy of it, which may be its beginning; or null.
     * @param progress hears how many bytes are there.
     * @throws IOException when the connection is lost; what has come stays.
     * @throws NoRoomException when there is not enough room for it, also when the disk becomes full meanwhile; what has come stays.
     * @throws ShrunkLogException when the log does not have so many bytes any longer.
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
            // Whoever removes the log from the robot relies on it.
            filling(log, part, 1) { file.force(true) }
        }
        return Whole(part, from)
    }

    /** Runs [work], which writes [bytes] of [log] to [part]. */
    private fun filling(log: RemoteLog, part: Path, bytes: Int, work: () -> Unit) = writing(part) {
        try {
            work()
        } catch (e: IOException) {
            // The system's own words for it differ by platform and language; the room that is left does not.
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
        // Only here: closing it waits for all that was asked for, and whoever gives up wants nothing more of the robot.
        RobotConnection.talking { stream.close() }
    }

    /** How many bytes of [log] are in [part] already, which is made anew where it holds others. */
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

    /** Whether [log] begins with [file], as far as a look at its two ends can tell: a log that is written anew differs there. */
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
     * The parts of logs of [robot] that are not among its [logs], and that nothing was added to for a day: these never become whole. A robot's
     * stick may be out for a while.
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
