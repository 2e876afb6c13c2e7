package badlog.terminal

import java.io.PrintStream

/**
 * Receives how far a piece of work is. Called on the thread that works; what it throws stops the work, which then leaves nothing
 * behind and passes the exception on.
 */
public fun interface Progress {
    /** [done] of [total] bytes, or other units, are done; [total] is an estimate where the input is still being written. */
    public fun advanced(done: Long, total: Long)
}

/**
 * Shows on a terminal how far a piece of work is, once it has taken a while. Closing it removes it from the terminal.
 *
 * @param label what is worked on.
 * @param delay nanoseconds before the bar appears.
 */
public class ProgressBar(label: String, err: PrintStream, private val isShown: Boolean, private val delay: Long = 500_000_000L) :
    Progress,
    AutoCloseable {
    private val label = label.takeLast(LABEL)
    private val start = System.nanoTime()
    private var percent = -1
    private val line = StatusLine(err)

    override fun advanced(done: Long, total: Long) {
        if (!isShown || System.nanoTime() - start < delay) return
        val now = if (total > 0) (done * 100 / total).coerceAtMost(100).toInt() else 100
        if (now == percent) return
        percent = now
        val filled = now * BAR / 100
        line.show("$label [${"#".repeat(filled)}${" ".repeat(BAR - filled)}] $now %")
    }

    override fun close(): Unit = line.close()

    private companion object {
        const val LABEL = 34
        const val BAR = 34
    }
}
