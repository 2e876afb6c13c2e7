package badlog.web

import java.util.concurrent.TimeUnit

/** Limits all downloads together to [bytesPerSecond]. The rest is left to the robot's loop, its disk and the field's radio. */
internal class Pace(private val bytesPerSecond: Long, private val clock: Clock) {
    private var next = clock.nanos()

    /** Waits until [bytes] more may be sent. */
    fun await(bytes: Int) {
        val start: Long
        synchronized(this) {
            val now = clock.nanos()
            // Unused time is not made up for.
            if (next - now < 0) next = now
            start = next
            next += TimeUnit.SECONDS.toNanos(bytes.toLong()) / bytesPerSecond
        }
        clock.awaitNanos(start)
    }
}
