package badlog.networktables.replay

/**
 * Follows [playhead] through [signals], and knows the current value of each.
 */
internal class Player(val signals: List<ReplayedTopic>, val playhead: Playhead) {
    // For each signal, the number of samples played, and the time of the last one.
    private val played = IntArray(signals.size)
    private val sinceMicros = LongArray(signals.size)

    /** Returns the current value of signal [signal]; null before its first sample. */
    fun current(signal: Int): Update? = if (played[signal] == 0) null else Update(signal, played[signal] - 1, sinceMicros[signal])

    /** Returns the changes until [nowNanos], in the order of time. After a jump, every signal has changed. */
    fun advance(nowNanos: Long): List<Update> {
        val updates = ArrayList<Update>()
        playhead.advance(nowNanos) { stretch ->
            val begin = updates.size
            for (signal in signals.indices) {
                if (stretch.isFresh) jump(signal, stretch, updates)
                play(signal, stretch, updates)
            }
            updates.subList(begin, updates.size).sortBy { it.micros }
        }
        return updates
    }

    private fun jump(signal: Int, stretch: Stretch, updates: MutableList<Update>) {
        played[signal] = signals[signal].countUntil(stretch.from)
        sinceMicros[signal] = stretch.nanosAt(stretch.from) / NANOS_PER_MICRO
        current(signal)?.let { updates += it }
    }

    private fun play(signal: Int, stretch: Stretch, updates: MutableList<Update>) {
        val samples = signals[signal].samples
        var next = played[signal]
        if (next == samples.size || samples.x[next] > stretch.to) return
        val end = signals[signal].countUntil(stretch.to)
        next = maxOf(next, end - MAX_OF_A_SIGNAL)
        while (next < end) {
            val micros = stretch.nanosAt(samples.x[next]) / NANOS_PER_MICRO
            updates += Update(signal, next++, micros)
            sinceMicros[signal] = micros
        }
        played[signal] = end
    }
}

/**
 * A value to send: sample [index] of signal [signal].
 *
 * @property micros its time on the server's clock.
 */
internal class Update(val signal: Int, val index: Int, val micros: Long)

private const val NANOS_PER_MICRO = 1000

/**
 * The maximum number of a signal's samples sent at once, such as when a laptop wakes up after an hour. The earliest are skipped.
 */
private const val MAX_OF_A_SIGNAL = 10_000
