package badlog.html.cli

import badlog.html.ExportProgress
import java.io.PrintStream

/**
 * Shows on a terminal how far an export is, when it takes long enough to wonder. Closed, it leaves no trace.
 *
 * @param label what is exported.
 * @param patience nanoseconds for which nothing is shown.
 */
class ProgressBar(label: String, private val err: PrintStream, private val isShown: Boolean, private val patience: Long = 500_000_000L) :
    ExportProgress,
    AutoCloseable {
    private val label = label.takeLast(LABEL)
    private val start = System.nanoTime()
    private var percent = -1
    private var width = 0

    override fun advanced(done: Long, total: Long) {
        if (!isShown || System.nanoTime() - start < patience) return
        val now = if (total > 0) (done * 100 / total).coerceAtMost(100).toInt() else 100
        if (now == percent) return
        percent = now
        val filled = now * BAR / 100
        val text = "$label [${"#".repeat(filled)}${" ".repeat(BAR - filled)}] $now %"
        err.print("\r" + text.padEnd(width))
        err.flush()
        width = text.length
    }

    override fun close() {
        if (width > 0) err.print("\r" + " ".repeat(width) + "\r")
        err.flush()
    }

    private companion object {
        const val LABEL = 34
        const val BAR = 34
    }
}
