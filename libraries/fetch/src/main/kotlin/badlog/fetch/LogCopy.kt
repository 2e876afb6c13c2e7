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
import java.security.MessageDigest
import java.util.HexFormat
import kotlin.math.min

/** A log shrank on the robot while it was copied. */
internal class ShrunkLogException : Exception()

/**
 * Copies logs into hidden parts in [folder], which only become logs when they are whole. A part that is there is gone on with.
 *
 * @param limit lets no more bytes pass than are wanted.
 * @param room how many bytes the disk of a folder has left.
 * @param checkpoint is called for each piece, and may throw to give up.
 */
internal class LogCopy(
    private val folder: Path,
    private val limit: BandwidthLimit,
    private val room: (Path) -> Long = { Files.getFileStore(it).usableSpace },
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
                writing(part) {
                    val buffer = ByteBuffer.wrap(bytes, 0, size)
                    while (buffer.hasRemaining()) file.write(buffer)
                }
            }
            // Whoever removes the log from the robot relies on it.
            writing(part) { file.force(true) }
        }
        return Whole(part, from)
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

    private fun partOf(robot: String, log: RemoteLog): Path {
        val digest = MessageDigest.getInstance("SHA-256").digest("$robot\n${log.path}".encodeToByteArray())
        return folder.resolve(".badlog-fetch-${HexFormat.of().formatHex(digest, 0, DIGEST)}.part")
    }

    private companion object {
        const val PIECE = 1 shl 16
        const val LOOK = 1 shl 14
        const val DIGEST = 10
        const val MEGA = 1_000_000
    }
}
