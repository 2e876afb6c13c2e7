package badlog.replay

/** Counts what clients sent and nobody understood. Safe for all threads. */
internal class IgnoredMessages {
    private var first: String? = null

    @get:Synchronized
    var count: Int = 0
        private set

    @Synchronized
    fun add(client: String, what: String) {
        if (count++ == 0) first = "“$client” sent $what"
    }

    /** A sentence about them, or null without any. */
    @get:Synchronized
    val note: String?
        get() = when (count) {
            0 -> null
            1 -> "A message was ignored: $first."
            else -> "$count messages were ignored; the first: $first."
        }
}
