package badlog.lib

import java.io.File
import java.io.IOException
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import kotlin.random.Random

/** The file of a log. */
internal class LogFile(path: File, val output: BagOutput) {
    /** Its path; changes when it is renamed. */
    @Volatile
    var path: File = path
        private set

    /** Whether the file no longer exists, although it can still be written to. */
    @Volatile
    var isMissing: Boolean = false

    /** Renames the file. Other threads must hold [lock] while they append. If renaming fails, returns false, and the name is unchanged. */
    fun rename(to: File, lock: Any): Boolean = output.rename(to, lock).also { if (it) path = to }

    /** Closes it. Reports a failure, since the disk may be gone by then. */
    fun close(faults: Faults) {
        try {
            output.close()
        } catch (failure: IOException) {
            faults.reportOnce("close") {
                "The log $path could not be closed: ${describe(failure)}. Its end may be missing."
            }
        }
    }

    /** Closes and deletes the file of a log that was closed before it began. */
    fun discard(faults: Faults) {
        close(faults)
        // Not a device or a pipe.
        if (path.isFile) path.delete()
    }

    companion object {
        /** Creates or truncates the file at [path]. If that is impossible, reports it once and returns null. */
        fun open(path: File, isCompressed: Boolean, faults: Faults, move: (from: File, to: File) -> Boolean = File::renameTo): LogFile? =
            try {
                val file = AppendFile(path, move)
                LogFile(path, if (isCompressed) GzipOutput(file) else PlainOutput(file))
            } catch (failure: IOException) {
                refused(path, failure, faults)
            } catch (failure: SecurityException) {
                refused(path, failure, faults)
            }

        private fun refused(path: File, failure: Exception, faults: Faults): LogFile? {
            faults.reportOnce("open") {
                "The log $path cannot be created: ${describe(failure)}. Nothing is logged; use a folder that " +
                    "exists and can be written to, such as /home/lvuser/logs."
            }
            return null
        }
    }
}

/** The names of a robot's logs, in the form of WPILib's names: `FRC_20260307_140212_OHCL_Q42.bag`. Times are in UTC. */
internal object LogName {
    private const val PROVISIONAL = "FRC_TBD_"
    private val LOG = Regex("FRC_.*\\.bag(\\.gz)?")
    private val TIME = DateTimeFormatter.ofPattern("yyyyMMdd_HHmmss").withZone(ZoneOffset.UTC)

    /** Returns a name for a log that began at an unknown time. */
    fun provisional(): String = PROVISIONAL + Random.nextLong().toULong().toString(16).padStart(16, '0')

    /** Returns the name of a log that began at [time]; [event] and [match] may be empty. */
    fun of(time: Instant, event: String, match: String): String =
        listOf("FRC", TIME.format(time), safe(event), safe(match)).filter { it.isNotEmpty() }.joinToString("_")

    fun isLog(name: String): Boolean = LOG.matches(name)

    fun isProvisional(name: String): Boolean = name.startsWith(PROVISIONAL)

    /** Returns a file called [name] in [folder] that does not exist; adds a number to the name if necessary. */
    fun free(folder: File, name: String, ending: String): File {
        var file = File(folder, name + ending)
        var number = 1
        while (file.exists()) file = File(folder, "${name}_${++number}$ending")
        return file
    }

    // The event's name comes from the field's system, and may contain a slash.
    private fun safe(text: String) = text.filter { it.isLetterOrDigit() || it == '-' }
}

/** The folder of a robot's logs. Chooses the folder, and deletes old logs when space runs out. */
internal class LogFolder(val path: File, private val freeBytes: (File) -> Long) {
    /** Whether there is too little space to log at all. */
    // A missing folder, such as on a removed stick, has no space either, but is not full.
    val isFull: Boolean get() = path.isDirectory && freeBytes(path) < STOP_BYTES

    /** Deletes the oldest logs until there is enough space, but keeps ten. Returns the deleted files. */
    fun makeSpace(): List<File> {
        val logs = path.listFiles { file -> LogName.isLog(file.name) }.orEmpty()
            // First those without a final name, because they were written without a Driver Station.
            .sortedWith(compareByDescending<File> { LogName.isProvisional(it.name) }.thenBy { it.lastModified() })
        val deleted = ArrayList<File>()
        for (log in logs.dropLast(KEPT_LOGS)) {
            if (freeBytes(path) >= ENOUGH_BYTES) break
            if (log.delete()) deleted += log
        }
        return deleted
    }

    companion object {
        private const val STOP_BYTES = 5L * 1024 * 1024
        private const val ENOUGH_BYTES = 50_000_000L
        private const val KEPT_LOGS = 10

        // The mount points of a USB stick and their link. Then the homes of the roboRIO and of Systemcore, and a simulation's folder.
        private val STICKS = listOf("/U", "/V", "/u").map(::File)
        private val HOMES = listOf("/home/lvuser", "/home/systemcore").map(::File)

        /** Returns [wanted], or the best available folder if it is null. */
        fun choose(wanted: File?, sticks: List<File> = STICKS, homes: List<File> = HOMES): File {
            if (wanted != null) return wanted
            val places = (sticks + homes).filter { it.isDirectory && it.canWrite() }
            return File(places.firstOrNull() ?: File("").absoluteFile, "logs")
        }
    }
}
