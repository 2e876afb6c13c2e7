package badlog.web

import java.util.concurrent.TimeUnit

/** The clock that downloads wait for: the system's, or a test's. */
internal open class Clock {
    /** Returns the time in nanoseconds since a fixed moment. */
    open fun nanos(): Long = System.nanoTime()

    /** Waits until [nanos], a time of this clock. */
    open fun awaitNanos(nanos: Long): Unit = TimeUnit.NANOSECONDS.sleep(nanos - nanos())
}
