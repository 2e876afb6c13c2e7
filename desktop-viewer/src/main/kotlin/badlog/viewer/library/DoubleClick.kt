package badlog.viewer.library

import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.TimeMark
import kotlin.time.TimeSource

/** Tells second clicks from first ones, without making a first one wait for a second. */
internal class DoubleClick {
    private var target: Any? = null
    private var at: TimeMark = TimeSource.Monotonic.markNow()

    /** Whether the click on [clicked] that comes now follows one on the same. */
    fun isSecondOn(clicked: Any): Boolean {
        val isSecond = clicked == target && at.elapsedNow() < LONGEST
        target = if (isSecond) null else clicked
        at = TimeSource.Monotonic.markNow()
        return isSecond
    }

    private companion object {
        val LONGEST = 450.milliseconds
    }
}
