package badlog.lib

import badlog.core.bag.BagParser
import badlog.core.recording.Recording
import com.sun.management.ThreadMXBean
import io.kotest.core.test.Enabled
import java.io.ByteArrayOutputStream
import java.io.EOFException
import java.io.File
import java.io.PrintStream
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.util.zip.GZIPInputStream

/** For tests in which another program deletes or renames a log that is being written. */
internal val IF_OPEN_FILES_GO: Enabled =
    if (File.separatorChar == '/') Enabled.enabled else Enabled.disabled("Windows deletes and renames no file that is open")

/** More than enough time for the thread that reports faults. */
internal const val MAX_PRINT_MILLIS = 60_000

/**
 * The least number of bytes that [work] allocates on this thread in some attempts. Sometimes the JVM itself allocates on a thread, when it
 * compiles the thread's code, and a busy machine compiles late. The work's own allocations would occur each time.
 */
internal fun garbageOf(work: () -> Unit): Long {
    val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean
    val thread = Thread.currentThread().id
    var least = Long.MAX_VALUE
    for (attempt in 1..20) {
        val before = threads.getThreadAllocatedBytes(thread)
        work()
        least = minOf(least, threads.getThreadAllocatedBytes(thread) - before)
        if (least == 0L) break
    }
    return least
}

/** Runs [test] with an empty folder, which is deleted afterwards. */
inline fun <T> inFolder(test: (File) -> T): T {
    val folder = Files.createTempDirectory("badlog").toFile()
    try {
        return test(folder)
    } finally {
        folder.walkBottomUp().forEach { it.setWritable(true) }
        folder.deleteRecursively()
    }
}

/** Returns the text that [action] writes to standard error. */
internal inline fun standardErrorOf(action: () -> Unit): String {
    val before = System.err
    StandardError.awaitPrinted(MAX_PRINT_MILLIS)
    val captured = ByteArrayOutputStream()
    System.setErr(PrintStream(captured, true, "UTF-8"))
    try {
        action()
    } finally {
        StandardError.awaitPrinted(MAX_PRINT_MILLIS)
        System.setErr(before)
    }
    return captured.toString("UTF-8")
}

fun recordingIn(bytes: ByteArray): Recording = BagParser().run {
    accept(bytes)
    finish()
}

fun recordingIn(file: File): Recording = recordingIn(file.readBytes())

/** Inflates as much as possible of [packed], which may be cut. */
fun inflated(packed: ByteArray): ByteArray {
    val out = ByteArrayOutputStream()
    val buffer = ByteArray(512)
    try {
        val stream = GZIPInputStream(packed.inputStream())
        while (true) {
            val count = stream.read(buffer)
            if (count < 0) break
            out.write(buffer, 0, count)
        }
    } catch (_: EOFException) {
        // Cut.
    }
    return out.toByteArray()
}

/** The lines of a bag after its two header lines. */
fun rowsIn(file: File): List<String> = file.readLines().drop(2)

/** Logs to a new file in [folder]: [create] makes topics, [loop] is the robot's loop. Returns the closed file. */
fun logged(folder: File, create: () -> Unit = {}, loop: (BadLog) -> Unit): File {
    val file = File(folder, "test.bag")
    BadLog.init(file.path).use { log ->
        create()
        log.finishInitialization()
        loop(log)
    }
    return file
}

fun BadLog.row() {
    updateTopics()
    log()
}
