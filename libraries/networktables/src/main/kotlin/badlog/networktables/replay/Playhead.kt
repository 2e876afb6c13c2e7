package badlog.networktables.replay

import kotlin.math.floor
import kotlin.math.roundToLong

/**
 * The position of a replay in a recording. It has no clock: every function receives the time, in nanoseconds that never go backwards.
 * Positions are in the unit of the recording's x axis. Initially paused at the start of [range].
 *
 * @property range the range that is played.
 * @property unitsPerSecond the advance of x in a second of the recording.
 * @property isLooping whether it continues at the start when it reaches the end; has no effect on a range without length.
 * @throws IllegalArgumentException when [range] is empty or not finite, or [speed] not above 0.
 */
internal class Playhead(
    val range: ClosedFloatingPointRange<Double>,
    private val unitsPerSecond: Double,
    speed: Double,
    isLooping: Boolean,
    nowNanos: Long,
) {
    /** The number of seconds of the recording that pass in a second. */
    var speed: Double = requireSpeed(speed)
        private set

    val isLooping: Boolean = isLooping && range.endInclusive > range.start

    var isPlaying: Boolean = false
        private set

    // It was at this position at that time, and moves evenly from there.
    private var anchorPosition = range.start
    private var anchorNanos = nowNanos
    private var reported = range.start
    private var isFresh = true

    private val length = range.endInclusive - range.start
    private val unitsPerNano get() = unitsPerSecond * speed * 1e-9

    init {
        require(range.start.isFinite() && range.endInclusive.isFinite() && range.start <= range.endInclusive) {
            "A replay needs a range that begins before it ends, not $range."
        }
    }

    fun position(nowNanos: Long): Double {
        if (!isPlaying) return anchorPosition
        val traveled = traveled(nowNanos)
        return range.start + if (isLooping) traveled - floor(traveled / length) * length else minOf(traveled, length)
    }

    fun isAtEnd(nowNanos: Long): Boolean = !isLooping && position(nowNanos) >= range.endInclusive

    fun play(nowNanos: Long) {
        anchor(position(nowNanos), nowNanos)
        isPlaying = true
    }

    fun pause(nowNanos: Long) {
        anchor(position(nowNanos), nowNanos)
        isPlaying = false
    }

    /** Jumps to [position], or to the nearer end of the range. */
    fun seek(position: Double, nowNanos: Long) {
        require(!position.isNaN()) { "The position of a replay must be a number." }
        anchor(position.coerceIn(range), nowNanos)
        reported = anchorPosition
        isFresh = true
    }

    fun changeSpeed(speed: Double, nowNanos: Long) {
        requireSpeed(speed)
        anchor(position(nowNanos), nowNanos)
        this.speed = speed
    }

    /**
     * Passes everything played since the last call to [visit], in order and without repetition. Of laps that began and ended since then,
     * only the last is reported, as the others could not have been seen.
     */
    fun advance(nowNanos: Long, visit: (Stretch) -> Unit) {
        if (isPlaying && isLooping) {
            val laps = floor(traveled(nowNanos) / length)
            if (laps >= 1) {
                visit(stretchTo(range.endInclusive))
                val lapBegan = anchorNanos + ((laps * length - (anchorPosition - range.start)) / unitsPerNano).roundToLong()
                // Rounded up, the lap would begin after [nowNanos].
                seek(range.start, minOf(lapBegan, nowNanos))
            }
        }
        val to = maxOf(position(nowNanos), reported)
        if (isFresh || to > reported) visit(stretchTo(to))
    }

    private fun stretchTo(to: Double): Stretch {
        val stretch = Stretch(reported, to, isFresh, anchorPosition, anchorNanos, unitsPerNano)
        reported = to
        isFresh = false
        return stretch
    }

    private fun traveled(nowNanos: Long) = anchorPosition - range.start + (nowNanos - anchorNanos) * unitsPerNano

    private fun anchor(position: Double, nowNanos: Long) {
        anchorPosition = position
        anchorNanos = nowNanos
    }
}

internal fun requireSpeed(speed: Double): Double {
    require(speed > 0 && speed.isFinite()) { "A replay's speed is a number above 0, 1 for real time, not $speed." }
    return speed
}

/**
 * A part of a recording that was played without a jump: samples after [from], up to and including [to].
 *
 * @property isFresh whether the playhead jumped to [from], so that the values there are new.
 */
internal class Stretch(
    val from: Double,
    val to: Double,
    val isFresh: Boolean,
    private val anchorPosition: Double,
    private val anchorNanos: Long,
    private val unitsPerNano: Double,
) {
    /** Returns the time when the playhead was at [position]. */
    fun nanosAt(position: Double): Long = anchorNanos + ((position - anchorPosition) / unitsPerNano).roundToLong()
}
