package badlog.networktables.record

import kotlin.math.abs

/**
 * Follows a server's clock, from answers to requests for its time. Times are in µs; those of this computer count from any moment.
 *
 * The quickest of the last answers counts: what a request waits for on its way makes the clock uncertain by half of that.
 */
internal class TimeSync {
    private class Answer(val offset: Long, val roundTrip: Long, val local: Long)

    private val answers = ArrayDeque<Answer>()

    /** The server's time minus this computer's; null until the first answer. */
    var offset: Long? = null
        private set

    /**
     * Takes the answer [server], which arrived at [local] to a request of [sent]. Returns whether the server's clock is another one than
     * before: it was set, or has started anew. It then counts from this answer on.
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
        // Each answer moves it a little; times that follow it should not tremble.
        if (was == null || isAnother || abs(now - was) > TREMBLE) offset = now
        return isAnother
    }

    /** Forgets the answers, which a later connection may not confirm, except for the last one to compare with. */
    fun disconnected() {
        val last = best ?: return
        answers.clear()
        answers.addLast(last)
    }

    private val best: Answer? get() = answers.minByOrNull { it.roundTrip }

    private fun tolerance(before: Answer, now: Answer) = SLACK + (before.roundTrip + now.roundTrip) / 2 + (now.local - before.local) / DRIFT

    private companion object {
        const val KEPT = 10

        const val TREMBLE = 2_000L

        /** Robots that restart are gone for longer. */
        const val SLACK = 250_000L

        /** Clocks of computers differ by less than 1 in 5,000. */
        const val DRIFT = 5_000
    }
}
