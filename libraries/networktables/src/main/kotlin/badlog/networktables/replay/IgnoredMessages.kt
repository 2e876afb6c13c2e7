package badlog.networktables.replay

/** Counts messages of clients that were not understood, and connections that were refused because there were too many. Thread-safe. */
internal class IgnoredMessages {
    private var first: String? = null
    private var refused: String? = null

    @get:Synchronized
    var count: Int = 0
        private set

    @Synchronized
    fun add(client: String, what: String) {
        if (count++ == 0) first = "“$client” sent $what"
    }

    /** A sentence about messages that were not understood; null if there are none. */
    @get:Synchronized
    val note: String?
        get() = when (count) {
            0 -> null
            1 -> "A message was ignored: $first."
            else -> "$count messages were ignored; the first: $first."
        }

    /** Records that [client] was refused because there were [most] connections. */
    @Synchronized
    fun refuse(client: String, most: Int) {
        refused = refused ?: "“$client” was refused: there are $most connections already; close another dashboard first."
    }

    /** A sentence about the first refused connection; null if there is none. */
    @get:Synchronized
    val refusal: String?
        get() = refused
}
