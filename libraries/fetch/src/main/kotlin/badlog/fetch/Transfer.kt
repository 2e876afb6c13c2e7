package badlog.fetch

import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.text.freeName
import badlog.files.LogName
import badlog.files.ReadOptions
import badlog.files.ReadResult
import badlog.files.ReadResult.Cause
import badlog.files.readLog
import badlog.files.safeName
import badlog.files.writing
import badlog.formats.LOG_FORMATS
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.clock.START_VALUE
import badlog.signals.match.dateInText
import badlog.signals.match.matchInName
import badlog.signals.match.matchOf
import org.apache.sshd.sftp.common.SftpConstants
import org.apache.sshd.sftp.common.SftpException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.attribute.FileTime
import java.time.Duration
import java.time.Instant

/**
 * Copies new logs to the folder of [options], and removes logs from the robot according to the options. Work done over one connection is
 * not repeated over the next.
 *
 * @param checkpoint called often; may throw to cancel.
 */
internal class Transfer(
    private val options: FetchOptions,
    private val here: FetchedLogs,
    private val listener: FetchListener,
    private val patience: Patience,
    private val checkpoint: () -> Unit,
) {
    private val done = HashSet<String>()
    private var hasReported = false
    private val copy = LogCopy(options.folder, BandwidthLimit(options.bytesPerSecond)) {
        if (Thread.interrupted()) throw InterruptedException()
        checkpoint()
    }

    val fetched = ArrayList<FetchedLog>()

    /** The number of logs that were already on this computer. */
    var known = 0
        private set

    /** The number of bytes received. */
    var received = 0L
        private set

    /** Does the remaining work over [connection]. */
    fun run(connection: RobotConnection) {
        val listing = listed(connection)
        if (!hasReported) for (name in listing.refused) skip(name, "“${safeName(name)}” is not a plain file name.")
        val wanted = listing.logs.filter { it.path !in done && isNew(connection, it) }.sortedByDescending { it.modified }
        if (!hasReported) {
            known = listing.logs.size - wanted.size
            listener.found(FoundLogs(wanted.size, wanted.sumOf { it.size }, known))
            hasReported = true
        }
        for (log in settled(connection, wanted)) fetch(connection, log)
        copy.leftParts(connection.robot, listing.logs).forEach(::keepUnfinished)
        options.deleteOlderThan?.let { age -> listing.logs.forEach { deleteIfOld(connection, it, age) } }
    }

    private fun listed(connection: RobotConnection): RemoteListing {
        options.robotFolders?.let { return connection.list(it) }
        val home = "/home/${connection.user}"
        return connection.list(listOf("$home/logs", "$home/log") + FOLDERS, listOf(home) + HOMES)
    }

    private fun isNew(connection: RobotConnection, log: RemoteLog): Boolean {
        val found = here.find(connection.robot, log.path) ?: return true
        return found.size != log.size || found.modified != log.modified
    }

    /** Returns the [logs] that are not being written. */
    private fun settled(connection: RobotConnection, logs: List<RemoteLog>): List<RemoteLog> {
        if (logs.isEmpty()) return logs
        checkpoint()
        Thread.sleep(patience.growth.toMillis())
        val now = listed(connection).logs.associateBy { it.path }
        return logs.filter { log ->
            val isSettled = now[log.path] == log
            if (!isSettled && done.add(log.path)) skipGrowing(log)
            isSettled
        }
    }

    private fun fetch(connection: RobotConnection, log: RemoteLog) {
        checkpoint()
        try {
            val found = here.find(connection.robot, log.path)
            var before = -1L
            val whole = copy.copy(connection, log, found?.let(here::fileOf)) { bytes ->
                if (before >= 0) received += bytes - before
                before = bytes
                listener.advanced(safeName(log.name), bytes, log.size)
            }
            if (connection.look(log) != log) return skipGrowing(log)
            keep(connection, log, whole)
        } catch (_: ShrunkLogException) {
            skipGrowing(log)
        } catch (e: SftpException) {
            if (e.status in LOST) throw e
            skip(log.path, "${printablePath(log.path)} cannot be read on the robot (${e.message}).")
        }
        done += log.path
    }

    /** Turns the complete part into a log. */
    private fun keep(connection: RobotConnection, log: RemoteLog, whole: LogCopy.Whole) {
        val read = readLog(whole.part, LOG_FORMATS, ReadOptions(name = log.name))
        if (read is ReadResult.NotRead) {
            // Nothing else can be fetched either.
            if (read.cause == Cause.NO_ROOM) read.orThrow()
            // It may be a good log. Its copy stays unchanged, and the next fetch tries it again.
            if (read.cause == Cause.BUG) return skip(log.path, read.sentence)
        }
        val recording = (read as? ReadResult.Read)?.recording
        val isLog = recording != null && !isFormerWpilog(log, recording)
        val match = if (recording != null && isLog) matchOf(recording, log.name) else matchInName(log.name)
        val place = LogPlace.of(log.name, match, recording?.takeIf { isLog }?.let(::startOf))
        val digest = FetchedLogs.digestOf(whole.part)
        val former = here.find(connection.robot, log.path)?.let(here::fileOf)?.takeIf { isBeginning(it, whole.part) }
        val file = moveTo(whole.part, place, former)
        // The window and file managers sort by it.
        writtenAt(log)?.let { time -> writing(file) { Files.setLastModifiedTime(file, FileTime.from(time)) } }
        val name = options.folder.relativize(file).joinToString("/")
        here.add(CopiedLog(connection.robot, log.path, log.size, log.modified, name, digest, System.currentTimeMillis()))
        done += log.path
        val isSalvaged = recording?.isSalvaged ?: true
        val result = FetchedLog(printablePath(log.path), file, log.size, whole.from, place.title, isLog, isSalvaged)
        fetched += result
        listener.fetched(result)
    }

    /**
     * Turns [part] into a log, because its log is no longer on the robot. Removes it if it contains no samples. If it cannot be read now,
     * it stays, because it is the only copy.
     */
    private fun keepUnfinished(part: Path) {
        val read = readLog(part, LOG_FORMATS)
        if (read is ReadResult.NotRead && !read.isLasting) {
            val message = "${read.sentence} The file has the start of a log that is no longer on the robot, and is kept."
            return listener.skipped(part.fileName.toString(), message, isGrowing = false)
        }
        val recording = (read as? ReadResult.Read)?.recording
        val size = Files.size(part)
        if (recording == null || recording.sampleCount == 0L) {
            writing(part) { Files.deleteIfExists(part) }
            val message = "The start of a log that is no longer on the robot was removed: nothing in it could be read."
            return listener.skipped(part.fileName.toString(), message, isGrowing = false)
        }
        val name = "unfinished${recording.format.endings.first()}"
        val place = LogPlace.of(name, matchOf(recording, name), startOf(recording))
        val file = moveTo(part, place, former = null)
        val message = "$file has the first $size bytes of a log that is no longer on the robot."
        listener.skipped(options.folder.relativize(file).joinToString("/"), message, isGrowing = false)
    }

    /** Returns the start of the log, in s since 1970 on a wall clock here; null if unknown. */
    private fun startOf(recording: Recording): Long? = recording.values.find { it.name == START_VALUE }?.let { dateInText(it.text) }

    private fun matchOf(recording: Recording, name: String) = RuleSet.BUILT_IN.signals.matchOf(recording, name)

    // Any bytes with line ends would count as a damaged table.
    private fun isFormerWpilog(log: RemoteLog, recording: Recording) =
        recording.format == RecordingFormat.CSV && recording.isSalvaged && LogName.of(log.name).ending.equals(".wpilog", ignoreCase = true)

    /** Moves [part] to [place] and replaces its [former] copy, which it continues. It does not replace other logs with the same name. */
    private fun moveTo(part: Path, place: LogPlace, former: Path?): Path {
        val folder = place.folder?.let(options.folder::resolve) ?: options.folder
        writing(folder) { Files.createDirectories(folder) }
        if (former != null && former.parent == folder) {
            writing(former) { Files.move(part, former, REPLACE_EXISTING) }
            return former
        }
        val stem = LogName.of(place.name).stem
        var target = folder
        freeName(stem, place.name.drop(stem.length)) { name ->
            target = folder.resolve(name)
            !Files.exists(target) || isSame(part, target)
        }
        writing(target) { if (Files.exists(target)) Files.delete(part) else Files.move(part, target, ATOMIC_MOVE) }
        return target
    }

    private fun isSame(part: Path, other: Path) = Files.isRegularFile(other) && Files.mismatch(part, other) < 0

    /** Returns whether [whole] starts with the bytes of [former]. */
    private fun isBeginning(former: Path, whole: Path): Boolean {
        if (!Files.isRegularFile(former)) return false
        val differs = Files.mismatch(former, whole)
        return differs < 0 || differs == Files.size(former)
    }

    private fun deleteIfOld(connection: RobotConnection, log: RemoteLog, age: Duration) {
        val found = here.find(connection.robot, log.path)?.takeIf { it.size == log.size && it.modified == log.modified } ?: return
        // A log with a wrong time counts as old as its copy here.
        val written = writtenAt(log) ?: Instant.ofEpochMilli(found.fetched)
        if (written > Instant.now().minus(age) || !here.isSafe(found)) return
        checkpoint()
        if (connection.look(log) != log) return
        try {
            connection.remove(log)
            listener.deleted(printablePath(log.path))
        } catch (e: SftpException) {
            if (e.status in LOST) throw e
            skip(log.path, "${printablePath(log.path)} cannot be removed from the robot (${e.message}).")
        }
    }

    /** Returns when [log] was last written; null if the robot's clock, which starts at about 1970, was not set. */
    private fun writtenAt(log: RemoteLog): Instant? = Instant.ofEpochSecond(log.modified).takeIf { it > BELIEVABLE }

    private fun skipGrowing(log: RemoteLog) {
        done += log.path
        val path = printablePath(log.path)
        listener.skipped(path, "$path is still being written; fetch again when the robot has started another log.", isGrowing = true)
    }

    private fun skip(path: String, message: String) {
        if (done.add(path)) listener.skipped(printablePath(path), message, isGrowing = false)
    }

    /** Returns [path] on one line. */
    private fun printablePath(path: String) = path.split('/').joinToString("/") { if (it.isEmpty()) it else safeName(it) }

    private companion object {
        val LOST = setOf(SftpConstants.SSH_FX_NO_CONNECTION, SftpConstants.SSH_FX_CONNECTION_LOST)

        /** The folders into which loggers write: on a USB stick, and in the homes of the robots' users. */
        val FOLDERS = listOf("/u/logs", "/U/logs", "/V/logs", "/home/lvuser/logs", "/home/systemcore/logs", "/home/lvuser/log")

        /** The folders with bags of the original badlog, beside other files: the user's home, and a USB stick. */
        val HOMES = listOf("/home/lvuser", "/media/sda1")
        val BELIEVABLE: Instant = Instant.parse("2015-01-01T00:00:00Z")
    }
}
