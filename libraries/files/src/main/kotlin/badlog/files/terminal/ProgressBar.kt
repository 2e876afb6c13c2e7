package badlog.files.terminal

import java.io.PrintStream
import kotlin.math.ceil
import kotlin.math.roundToInt

/**
 * Receives the progress of a piece of work. Called on the working thread. An exception from it stops the work, which then leaves nothing behind and
 * passes the exception on.
 */
public fun interface Progress {
    /** Called when [done] of [total] bytes, or other units, are done. [total] is an estimate if the input is still being written. */
    public fun advanced(done: Long, total: Long)
}

/**
 * Shows on a terminal the progress of a piece of work and the remaining time, after a delay. Closing it removes it from the terminal.
 *
 * @param label names the work.
 * @param delay the time before the bar appears, in ns.
 * @param clock returns nanoseconds since an arbitrary moment.
 */
public class ProgressBar(
    label: String,
    err: PrintStream,
    private val isShown: Boolean,
    private val delay: Long = 500_000_000L,
    private val clock: () -> Long = System::nanoTime,
) : Progress,
    AutoCloseable {
    private val label = label.takeLast(LABEL)
    private val start = clock()
    private var percent = -1
    private var second = -1L
    private val line = StatusLine(err)

    override fun advanced(done: Long, total: Long) {
        if (!isShown) return
        val taken = clock() - start
        if (taken < delay) return
        val now = if (total > 0) (done * 100 / total).coerceAtMost(100).toInt() else 100
        if (now == percent && taken / SECOND == second) return
        percent = now
        second = taken / SECOND
        val filled = now * BAR / 100
        val left = if (now in 1..99) ", ${timeLeft(taken.toDouble() / SECOND * (total - done) / done)}" else ""
        line.show("$label [${"#".repeat(filled)}${" ".repeat(BAR - filled)}] $now %$left")
    }

    override fun close(): Unit = line.close()
}

/**
 * Returns [seconds] with the precision of an estimate, such as `12 s left`. It is in minutes from a minute and a half on, and in hours from
 * an hour and a half on.
 */
internal fun timeLeft(seconds: Double): String = when {
    seconds < MIN_MINUTES -> "${ceil(seconds).toInt()} s left"
    seconds < MIN_HOURS -> "${(seconds / MINUTE).roundToInt()} min left"
    else -> "${(seconds / HOUR).roundToInt()} h left"
}

private const val MINUTE = 60
private const val HOUR = 3600
private const val MIN_MINUTES = 90
private const val MIN_HOURS = 5400

// Together with the remaining time, this fits in 80 columns.
private const val LABEL = 34
private const val BAR = 20

/** A second, in ns. */
private const val SECOND = 1_000_000_000L
