package badlog.season.engine

import java.nio.file.Files
import java.nio.file.Path

/** A folder for temporary files. It is deleted when it is closed, or when the program ends after the work in it is finished. */
internal class ScratchFolder : AutoCloseable {
    val path: Path = Files.createTempDirectory("badlog-duckdb")

    // Shutdown hooks run concurrently, so one hook waits for the work and then deletes the folder.
    private val hook = Thread({ end() }, "badlog-end")
    private val finishes = ArrayList<() -> Unit>()
    private var isEnding = false

    init {
        try {
            Runtime.getRuntime().addShutdownHook(hook)
        } catch (_: IllegalStateException) {
            isEnding = true
        }
    }

    /**
     * Runs [work]. If the program is asked to end meanwhile, [finish] runs on another thread before the folder is deleted and the program
     * ends.
     *
     * @throws InterruptedException if the program is already ending; it does not wait for new work.
     */
    fun <R> finishing(finish: () -> Unit, work: () -> R): R {
        synchronized(finishes) {
            if (isEnding) throw InterruptedException("The program ends.")
            finishes += finish
        }
        try {
            return work()
        } finally {
            synchronized(finishes) { finishes.remove(finish) }
        }
    }

    /** Ends all work that is still running, and deletes the folder. Called when the program ends. */
    fun end() {
        val unfinished = synchronized(finishes) {
            isEnding = true
            finishes.toList()
        }
        try {
            unfinished.forEach { it() }
        } finally {
            remove()
        }
    }

    override fun close() {
        remove()
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (_: IllegalStateException) {
            // The hook is already running.
        }
    }

    private fun remove() {
        path.toFile().deleteRecursively()
    }
}
