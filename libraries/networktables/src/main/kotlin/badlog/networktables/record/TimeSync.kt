package badlog.networktables.record

import kotlin.math.abs

/**
 * Tracks a server's clock by its answers to requests for the time. Times are in µs; this computer's have an arbitrary origin.
 *
 * Only the quickest of the last answers counts: the clock's uncertainty is half of the round trip.
 */
internal class TimeSync {
    private class Answer(val offset: Long, val roundTrip: Long, val local: Long)

    private val answers = ArrayDeque<Answer>()

    /** The server's time minus this computer's; null until the first answer. */
    var offset: Long? = null
        private set

    /**
     * Handles the answer [server], received at [local] to a request sent at [sent]. Returns whether the server's clock was set or
     * restarted; only answers from this one on count then.
     */
    fun answered(sent: Long, server: Long, local: Long): Boolean {
        val roundTrip = local - sent
        if (roundTrip < 0) return false
        val answer = Answer(server + roundTrip / 2 - local, roundTrip, local)
        val before = best
        val isAnother = before != null && abs(answer.offset - before.offset) > tolerance(before, answer)
        if (isAnother) answers.clear()
        answers.addLast(answer)
        if (answers.size > KEPT) answers.removeFirst()
        val now = checkNotNull(best).offset
        val was = offset
        // Small corrections are skipped, so that converted times do not jitter.
        if (was == null || isAnother || abs(now - was) > JITTER_MICROS) offset = now
        return isAnother
    }

    /** Forgets all answers but the quickest, with which the next connection is compared. */
    fun disconnected() {
        val last = best ?: return
        answers.clear()
        answers.addLast(last)
    }

    private val best: Answer? get() = answers.minByOrNull { it.roundTrip }

    private fun tolerance(before: Answer, now: Answer) = SLACK + (before.roundTrip + now.roundTrip) / 2 + (now.local - before.local) / DRIFT
}

private const val KEPT = 10

private const val JITTER_MICROS = 2_000L

/** The tolerated deviation of an answer, in µs. A restarting robot is away for longer. */
private const val SLACK = 250_000L

/** The inverse of the tolerated drift. Clocks of computers differ by less than 1 in 5,000. */
private const val DRIFT = 5_000
