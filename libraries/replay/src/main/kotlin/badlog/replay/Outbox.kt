package badlog.replay

/**
 * Values that one client still has to get, in bounded memory: where it is too slow for all of them, it gets only the latest of
 * each topic.
 */
internal class Outbox(signalCount: Int, private val limit: Int) {
    private val waiting = ArrayDeque<Update>()

    // Of the topics of which only the latest is wanted; in the order in which they became news.
    private val latest = LinkedHashMap<Int, Update>()
    private val dueMicros = LongArray(signalCount)

    val isEmpty: Boolean get() = waiting.isEmpty() && latest.isEmpty()

    /** Puts in a value that is sent as soon as possible, and after all others that were put in like this. */
    fun add(update: Update) {
        waiting.addLast(update)
        if (waiting.size > limit) keepLast()
    }

    /** Puts in a value that is sent when its topic is due, unless a newer one comes before. */
    fun replace(update: Update) {
        latest[update.signal] = update
    }

    /** Takes out what can be sent at [nowMicros], at most [most] values; [periodMicros] is how long a topic then rests. */
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

    /** Forgets the values of the topics that are not [wanted] any longer. */
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
