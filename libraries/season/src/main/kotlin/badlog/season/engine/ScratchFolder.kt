package badlog.season.engine

import java.nio.file.Files
import java.nio.file.Path

/** A folder for temporary files, which goes when it is closed, or when the program ends and the work in it is finished. */
internal class ScratchFolder : AutoCloseable {
    val path: Path = Files.createTempDirectory("badlog-duckdb")

    // Hooks of the program run at the same time: the one that waits for the work must be the one that removes the folder.
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
     * Does [work]. If the program is asked to end meanwhile, [finish] runs on another thread before the folder goes and the program ends.
     *
     * @throws InterruptedException if the program is already ending, which does not wait for work that begins now.
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

    /** Does what the program does at its end: finishes the work, and removes the folder. */
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
            // It is already running.
        }
    }

    private fun remove() {
        path.toFile().deleteRecursively()
    }
}
