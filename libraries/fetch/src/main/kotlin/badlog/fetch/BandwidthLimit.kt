package badlog.fetch

import java.util.concurrent.TimeUnit

/**
 * Lets no more than [bytesPerSecond] pass, or all where it is null.
 *
 * @param now the time in nanoseconds.
 * @param sleep waits for milliseconds.
 */
internal class BandwidthLimit(
    private val bytesPerSecond: Long?,
    private val now: () -> Long = System::nanoTime,
    private val sleep: (millis: Long) -> Unit = Thread::sleep,
) {
    // When all that has passed would have passed at that rate.
    private var due = now()

    /** [bytes] have come; waits until more may. */
    fun spend(bytes: Int) {
        val rate = bytesPerSecond ?: return
        // What was not used while nothing came is gone.
        due = maxOf(due, now()) + bytes * NANOS / rate
        val millis = TimeUnit.NANOSECONDS.toMillis(due - now())
        if (millis > 0) sleep(millis)
    }

    private companion object {
        const val NANOS = 1_000_000_000L
    }
}
