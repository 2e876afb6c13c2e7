package badlog.files

import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.Future
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import kotlin.math.ceil

/**
 * Works on many files on all cores at once, and returns the results in the order of the files.
 *
 * Few files are in progress at a time, so the memory does not grow with their number. A file that is large for the heap is
 * processed alone.
 *
 * @param threads the number of files processed at once.
 */
public class FolderRun(private val threads: Int = Runtime.getRuntime().availableProcessors()) {
    private val room = Semaphore(ROOM, true)

    /**
     * Runs [work] on each of [files], and passes it the number of cores to use. Passes each result to [each] on this thread. An exception
     * from [work], [waiting] or [each] stops everything and is passed on.
     *
     * @param waiting called on this thread several times a second until the next result is available.
     */
    public fun <R> forEach(
        files: List<LogFile>,
        work: (file: LogFile, cores: Int) -> R,
        waiting: () -> Unit = {},
        each: (LogFile, R) -> Unit,
    ) {
        // The cores that no other file uses.
        val cores = threads / files.size.coerceIn(1, threads)
        val pool = Executors.newFixedThreadPool(threads) { Thread(it, "badlog-logs").apply { isDaemon = true } }
        try {
            val underWay = ArrayDeque<Pair<LogFile, Future<R>>>()
            for (file in files) {
                underWay += file to pool.submit<R> { withRoom(file) { work(file, cores) } }
                if (underWay.size >= threads * AHEAD) finishFirst(underWay, waiting, each)
            }
            while (underWay.isNotEmpty()) finishFirst(underWay, waiting, each)
        } finally {
            pool.shutdownNow()
        }
    }

    private fun <R> finishFirst(underWay: ArrayDeque<Pair<LogFile, Future<R>>>, waiting: () -> Unit, each: (LogFile, R) -> Unit) {
        val (file, future) = underWay.removeFirst()
        each(file, resultOf(future, waiting))
    }

    private fun <R> resultOf(future: Future<R>, waiting: () -> Unit): R {
        while (true) {
            try {
                return future.get(PATIENCE, TimeUnit.MILLISECONDS)
            } catch (_: TimeoutException) {
                waiting()
            } catch (e: ExecutionException) {
                throw e.cause ?: e
            }
        }
    }

    private fun <R> withRoom(file: LogFile, work: () -> R): R {
        val growth = if (PACKED.any { file.name.endsWith(it, ignoreCase = true) }) GROWTH_OF_GZIP else GROWTH
        val needed = ceil(ROOM * minOf(1.0, file.size * growth / (Runtime.getRuntime().maxMemory() * SHARE))).toInt()
        room.acquire(needed)
        try {
            return work()
        } finally {
            room.release(needed)
        }
    }

    private companion object {
        val PACKED = listOf(".gz", ".wpilogxz", ".hoot")
        const val AHEAD = 4
        const val ROOM = 1000

        /** The time between calls of `waiting`, in ms. */
        const val PATIENCE = 200L

        /** The estimated part of the heap that logs in progress may fill. */
        const val SHARE = 0.6

        /** The estimated memory of a log per byte of its file: the samples, and the results of expressions. */
        const val GROWTH = 3.0
        const val GROWTH_OF_GZIP = 15.0
    }
}
