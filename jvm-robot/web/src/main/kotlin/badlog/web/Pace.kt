package badlog.web

import java.util.concurrent.TimeUnit

/** Holds all downloads together to [bytesPerSecond], so that a robot's loop, its disk and the field's radio have the rest. */
internal class Pace(private val bytesPerSecond: Long, private val clock: Clock) {
    private var next = clock.nanos()

    /** Waits until [bytes] more may be sent. */
    fun await(bytes: Int) {
        val start: Long
        synchronized(this) {
            val now = clock.nanos()
            // Time that nobody used is not made up for.
            if (next - now < 0) next = now
            start = next
            next += TimeUnit.SECONDS.toNanos(bytes.toLong()) / bytesPerSecond
        }
        clock.awaitNanos(start)
    }
}
