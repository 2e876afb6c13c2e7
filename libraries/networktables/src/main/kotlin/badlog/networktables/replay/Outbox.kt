package badlog.networktables.replay

/**
 * Values still to be sent to one client, in limited memory. A client that is too slow for all of them only gets the latest of each topic.
 */
internal class Outbox(signalCount: Int, private val limit: Int) {
    private val waiting = ArrayDeque<Update>()

    // Values of topics subscribed to for their latest value only, in the order of their changes.
    private val latest = LinkedHashMap<Int, Update>()
    private val dueMicros = LongArray(signalCount)

    val isEmpty: Boolean get() = waiting.isEmpty() && latest.isEmpty()

    /** Adds a value that is sent as soon as possible, after all others that were added with this function. */
    fun add(update: Update) {
        waiting.addLast(update)
        if (waiting.size > limit) keepLast()
    }

    /** Adds a value that is sent when its topic is due, unless a newer one replaces it. */
    fun replace(update: Update) {
        latest[update.signal] = update
    }

    /**
     * Removes and returns the values that can be sent at [nowMicros], at most [most]. [periodMicros] is the time until a topic is due
     * again.
     */
    fun take(nowMicros: Long, most: Int, periodMicros: LongArray): List<Update> {
        val taken = ArrayList<Update>(minOf(most, waiting.size))
        while (taken.size < most && waiting.isNotEmpty()) taken += waiting.removeFirst()
        val candidates = latest.values.iterator()
        while (taken.size < most && candidates.hasNext()) {
            val update = candidates.next()
            if (dueMicros[update.signal] > nowMicros) continue
            dueMicros[update.signal] = nowMicros + periodMicros[update.signal]
            taken += update
            candidates.remove()
        }
        return taken
    }

    /** Removes the values of topics that are no longer [wanted]. */
    fun retain(wanted: (signal: Int) -> Boolean) {
        waiting.removeAll { !wanted(it.signal) }
        latest.keys.removeAll { !wanted(it) }
    }

    private fun keepLast() {
        val lastOf = LinkedHashMap<Int, Update>()
        for (update in waiting) {
            lastOf.remove(update.signal)
            lastOf[update.signal] = update
        }
        waiting.clear()
        waiting.addAll(lastOf.values)
    }
}
