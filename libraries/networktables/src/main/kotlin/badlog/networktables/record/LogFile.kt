package badlog.networktables.record

import badlog.formats.wpilog.WpilogStream
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * A log that is being written. Its name follows the scheme of WPILib's `DataLogManager`: `FRC_yyyyMMdd_HHmmss.wpilog`, in UTC, with event
 * and match if known. [Flushed][flush] data is on the disk a tenth of a second later. Use it on one thread.
 *
 * @param path its first name; the file exists and is empty.
 * @property startMicros the robot's time when the log started, in µs.
 */
internal class LogFile private constructor(path: Path, private val channel: FileChannel, val startMicros: Long) : AutoCloseable {
    /** Its current name. */
    var path: Path = path
        private set

    /** Its size in bytes, without unflushed data. */
    @Volatile
    var bytes: Long = 0
        private set

    @Volatile
    private var isDirty = false
    private var nameEnd: String? = null
    private val stem = path.fileName.toString().removeSuffix(ENDING)
    private val stream = WpilogStream(::write)
    private val syncs = Executors.newSingleThreadScheduledExecutor { Thread(it, "record sync").apply { isDaemon = true } }

    init {
        syncs.scheduleWithFixedDelay(::sync, SYNC_MILLIS, SYNC_MILLIS, TimeUnit.MILLISECONDS)
    }

    fun start(name: String, type: String, metadata: String, micros: Long): Int = stream.start(name, type, metadata, micros)

    fun record(entry: Int, micros: Long, payload: ByteArray): Unit = stream.record(entry, micros, payload)

    fun changeMetadata(entry: Int, metadata: String, micros: Long): Unit = stream.changeMetadata(entry, metadata, micros)

    fun finish(entry: Int, micros: Long): Unit = stream.finish(entry, micros)

    /** Passes all written data to the operating system. */
    fun flush(): Unit = stream.flush()

    /** Adds [end] to the file's name, once. If the system refuses, closing the file tries again if [retriesOnClose]. */
    fun rename(end: String, retriesOnClose: Boolean) {
        if (nameEnd != null) return
        nameEnd = end
        move()
        if (!retriesOnClose) nameEnd = ""
    }

    /** Writes the remaining data and closes the file. */
    override fun close() {
        try {
            flush()
        } finally {
            syncs.shutdown()
            syncs.awaitTermination(1, TimeUnit.SECONDS)
            channel.use(::force)
            move()
        }
    }

    private fun move() {
        val end = nameEnd.orEmpty()
        if (end.isEmpty()) return
        val target = path.resolveSibling(stem + end + ENDING)
        if (target == path) return
        try {
            Files.move(path, target)
            path = target
        } catch (_: IOException) {
            // The file keeps its first name.
        }
    }

    private fun write(piece: ByteArray, size: Int) {
        val buffer = ByteBuffer.wrap(piece, 0, size)
        while (buffer.hasRemaining()) channel.write(buffer)
        bytes += size
        isDirty = true
    }

    private fun sync() {
        if (!isDirty) return
        isDirty = false
        force(channel)
    }

    private fun force(channel: FileChannel) = try {
        channel.force(false)
    } catch (_: IOException) {
        // The next write reports it.
    }

    companion object {
        private const val ENDING = ".wpilog"
        private const val SYNC_MILLIS = 100L
        private val NAME = DateTimeFormatter.ofPattern("yyyyMMdd_HHmmss").withZone(ZoneOffset.UTC)

        /** Creates a log in [folder], named after [now], or after a later second if that name is taken. Throws [IOException]. */
        fun create(folder: Path, now: Instant, startMicros: Long): LogFile {
            Files.createDirectories(folder)
            var time = now
            while (true) {
                val stem = "FRC_${NAME.format(time)}"
                time = time.plusSeconds(1)
                // A log of that second may already be named after its match.
                val isTaken = Files.newDirectoryStream(folder, "$stem*").use { it.iterator().hasNext() }
                if (isTaken) continue
                val path = folder.resolve(stem + ENDING)
                try {
                    val channel = FileChannel.open(path, StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW)
                    return LogFile(path, channel, startMicros)
                } catch (_: FileAlreadyExistsException) {
                    continue
                }
            }
        }
    }
}
