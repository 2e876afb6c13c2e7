package badlog.networktables.replay

/** The subscriptions of one client, evaluated for each of [signals]. */
internal class Subscriptions(private val signals: List<ReplayedTopic>) {
    private class Subscription(val request: Request.Subscribe, val signals: IntArray)

    private val idOfName = HashMap<String, Int>().apply { signals.forEachIndexed { id, signal -> put(signal.name, id) } }
    private val subscriptions = HashMap<Long, Subscription>()
    private val wantsAll = BooleanArray(signals.size)

    /** For each signal, the period at which its latest value is sent; [NEVER] if its values are not wanted. */
    val periodMicros = LongArray(signals.size) { NEVER }

    /** The number of names in all subscriptions. */
    val nameCount: Int get() = subscriptions.values.sumOf { it.request.names.size }

    fun idOf(name: String): Int? = idOfName[name]

    fun wantsValues(signal: Int): Boolean = periodMicros[signal] != NEVER

    /** Returns whether every value is wanted, not only the latest. */
    fun wantsAll(signal: Int): Boolean = wantsAll[signal]

    /** Adds [request], replacing an earlier one with the same id. Returns the signals that it selects. */
    fun add(request: Request.Subscribe): IntArray {
        val subscription = Subscription(request, matches(request))
        if (subscriptions.put(request.id, subscription) == null) apply(subscription) else applyAll()
        return subscription.signals
    }

    fun remove(id: Long) {
        if (subscriptions.remove(id) != null) applyAll()
    }

    private fun matches(request: Request.Subscribe): IntArray {
        if (!request.isPrefix) return request.names.mapNotNull { idOfName[it] }.distinct().toIntArray()
        return signals.indices.filter { id -> request.names.any { signals[id].name.startsWith(it) } }.toIntArray()
    }

    private fun applyAll() {
        periodMicros.fill(NEVER)
        wantsAll.fill(false)
        subscriptions.values.forEach(::apply)
    }

    private fun apply(subscription: Subscription) {
        val request = subscription.request
        if (request.isTopicsOnly) return
        for (signal in subscription.signals) {
            periodMicros[signal] = minOf(periodMicros[signal], request.periodMicros)
            if (request.isAll) wantsAll[signal] = true
        }
    }
}

private const val NEVER = Long.MAX_VALUE
