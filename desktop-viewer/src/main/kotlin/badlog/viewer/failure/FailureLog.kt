package badlog.viewer.failure

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.time.LocalDateTime
import java.time.temporal.ChronoUnit

/** What went wrong in the program itself, for whoever mends it: kept in [file], each failure once a run. For any thread. */
internal class FailureLog(cache: Path) {
    /** Where it is kept. */
    val file: Path = cache.resolve("failures.log")

    private val known = HashSet<String>()

    /** Adds [failure]. Returns whether it can be read there; not on a full disk, or after very many others. */
    @Synchronized
    fun add(failure: Throwable): Boolean {
        val trace = failure.stackTraceToString()
        if (trace in known) return true
        if (known.size >= MOST) return false
        try {
            Files.createDirectories(file.parent)
            if (Files.exists(file) && Files.size(file) > LARGEST) Files.delete(file)
            Files.writeString(file, "${place()}\n$trace\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND)
        } catch (_: IOException) {
            return false
        }
        return known.add(trace)
    }

    private fun place(): String {
        val system = listOf("os.name", "os.version", "os.arch", "java.version").joinToString(" ") { System.getProperty(it) }
        return "${LocalDateTime.now().truncatedTo(ChronoUnit.SECONDS)} $system"
    }

    private companion object {
        /** One that fails in each frame must not fill the disk. */
        const val MOST = 50
        const val LARGEST = 1L shl 20
    }
}
