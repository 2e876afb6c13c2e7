package badlog.exporter

import java.util.concurrent.ExecutionException
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import java.util.concurrent.Future
import java.util.concurrent.TimeUnit

/** The threads of one export: one per core to deflate, and one to parse. */
internal class ExportThreads : AutoCloseable {
    private val deflaters = pool("badlog-deflate", CORES)
    private val parser = pool("badlog-parse", 1)

    /** Runs [work] on any core. */
    fun deflate(work: () -> Unit): Future<*> = deflaters.submit(work)

    /** Runs [work] after all work that was submitted here before. */
    fun parse(work: () -> Unit): Future<*> = parser.submit(work)

    /** Drops work that has not begun, and waits for work that has. */
    override fun close() {
        deflaters.shutdownNow()
        parser.shutdownNow()
        deflaters.awaitTermination(1, TimeUnit.MINUTES)
        parser.awaitTermination(1, TimeUnit.MINUTES)
    }

    companion object {
        val CORES = Runtime.getRuntime().availableProcessors()

        /** Waits for [work] and rethrows its exceptions. */
        fun await(work: Future<*>) {
            try {
                work.get()
            } catch (e: ExecutionException) {
                throw e.cause ?: e
            }
        }

        private fun pool(name: String, size: Int): ExecutorService =
            Executors.newFixedThreadPool(size) { work -> Thread(work, name).apply { isDaemon = true } }
    }
}
