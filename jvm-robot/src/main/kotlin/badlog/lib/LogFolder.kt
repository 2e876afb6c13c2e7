package badlog.lib

import java.io.File

/** The folder in which a robot's logs lie: which one, and what is deleted there when space is short. */
internal class LogFolder(val path: File, private val freeBytes: (File) -> Long) {
    /** Whether there is too little space to log at all. */
    // What is not there, such as a stick that was pulled out, has no space either, but is not full.
    val isFull: Boolean get() = path.isDirectory && freeBytes(path) < STOP_BYTES

    /** Deletes the oldest logs until there is space enough, but keeps ten. Returns what it deleted. */
    fun makeSpace(): List<File> {
        val logs = path.listFiles { file -> LogName.isLog(file.name) }.orEmpty()
            // Those that never got a name first: nobody was there when they were written.
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

        // A USB stick, the roboRIO's and Systemcore's own, and where a simulation runs.
        private val STICK = File("/u")
        private val HOMES = listOf("/home/lvuser", "/home/systemcore").map(::File)

        /** The folder that was [wanted], or the best there is. */
        fun choose(wanted: File?, stick: File = STICK, homes: List<File> = HOMES): File {
            if (wanted != null) return wanted
            val places = (listOf(stick) + homes).filter { it.isDirectory && it.canWrite() }
            return File(places.firstOrNull() ?: File("").absoluteFile, "logs")
        }
    }
}
