package badlog.web

/** Holds all downloads together to [bytesPerSecond], so that a robot's loop, its disk and the field's radio have the rest. */
internal class Pace(private val bytesPerSecond: Long) {
    private var next = System.nanoTime()

    /** Waits until [bytes] more may be sent. */
    fun await(bytes: Int) {
        val wait: Long
        synchronized(this) {
            val now = System.nanoTime()
            // Time that nobody used is not made up for.
            if (next - now < 0) next = now
            wait = next - now
            next += bytes * NANOS / bytesPerSecond
        }
        if (wait > 0) Thread.sleep(wait / NANOS_IN_MILLI, (wait % NANOS_IN_MILLI).toInt())
    }

    private companion object {
        const val NANOS = 1_000_000_000L
        const val NANOS_IN_MILLI = 1_000_000L
    }
}
