package badlog.fetch

import java.util.concurrent.TimeUnit

/**
 * Limits a transfer to [bytesPerSecond]; null for no limit.
 *
 * @param now returns the time in nanoseconds.
 * @param sleep waits for a number of milliseconds.
 */
internal class BandwidthLimit(
    private val bytesPerSecond: Long?,
    private val now: () -> Long = System::nanoTime,
    private val sleep: (millis: Long) -> Unit = Thread::sleep,
) {
    // The time at which all bytes so far would be due at that rate.
    private var due = now()

    /** Records that [bytes] were transferred, and waits until more are allowed. */
    fun spend(bytes: Int) {
        val rate = bytesPerSecond ?: return
        // Unused bandwidth is not saved up.
        due = maxOf(due, now()) + bytes * NANOS / rate
        val millis = TimeUnit.NANOSECONDS.toMillis(due - now())
        if (millis > 0) sleep(millis)
    }
}

private const val NANOS = 1_000_000_000L
