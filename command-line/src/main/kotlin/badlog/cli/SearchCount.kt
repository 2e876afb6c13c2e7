package badlog.cli

import badlog.cli.text.grouped
import java.io.PrintStream

/**
 * Shows on a terminal how many files were looked at for logs, when that takes long enough to wonder. Closed, it leaves no trace.
 *
 * @param patience nanoseconds for which nothing is shown, and after which it is shown anew.
 */
internal class SearchCount(private val err: PrintStream, private val isShown: Boolean, private val patience: Long = 500_000_000L) :
    AutoCloseable {
    private var shown = System.nanoTime()
    private var files = 0L
    private var width = 0

    /** Another file was looked at. */
    fun next() {
        files++
        if (!isShown || System.nanoTime() - shown < patience) return
        shown = System.nanoTime()
        val text = "looking for logs: ${grouped(files)} files"
        err.print("\r" + text.padEnd(width))
        err.flush()
        width = text.length
    }

    override fun close() {
        if (width > 0) err.print("\r" + " ".repeat(width) + "\r")
        err.flush()
    }
}
