package badlog.web

import java.util.concurrent.TimeUnit

/** The time by which downloads wait: this computer's, or what a test makes of it. */
internal open class Clock {
    /** Returns the time in nanoseconds, from any moment. */
    open fun nanos(): Long = System.nanoTime()

    /** Waits until it is [nanos]. */
    open fun awaitNanos(nanos: Long): Unit = TimeUnit.NANOSECONDS.sleep(nanos - nanos())
}
