package badlog.lib

import java.util.concurrent.ConcurrentHashMap

/**
 * Handles the faults in a robot's loop. Each is counted every time, reported once by [StandardError], and noted as an event if the log has
 * [room] for events. Never throws.
 *
 * Messages are built only when they are reported, so that a fault in each loop does not produce garbage in each.
 */
internal class Faults(val counters: Counters) {
    // Three sets, because a program's names must not clash with each other or with the log's own subjects.
    private val reported = ConcurrentHashMap.newKeySet<String>()
    private val ignoredCalls = ConcurrentHashMap.newKeySet<String>()
    private val ignoredNames = ConcurrentHashMap.newKeySet<String>()

    /** The column in which faults are noted as events; null if there is none. */
    @Volatile
    var room: EventSink? = null

    /** Handles a fault of [topic]: its cell stays empty in this row. */
    fun cellMissed(topic: Topic, cause: Throwable) = cellMissed(topic) { "threw ${describe(cause)}" }

    inline fun cellMissed(topic: Topic, what: () -> String) {
        counters.cellsMissed.incrementAndGet()
        if (topic.isFaultReported) return
        topic.isFaultReported = true
        report("The topic \"${topic.name}\" ${what()}, so its cell is empty. Further gaps of this topic are only counted.")
    }

    /** Handles a call that is ignored. Each different [about] is reported once. */
    inline fun callIgnored(about: String, why: () -> String) {
        if (isNewCall(about)) report(why())
    }

    /** Handles a value that was published to [name] but is ignored. */
    inline fun publishIgnored(name: String?, why: () -> String) {
        if (isNewName(name ?: "")) report(why())
    }

    /** Reports [message], unless something was already reported about [about], one of the log's few fixed subjects. */
    inline fun reportOnce(about: String, message: () -> String) {
        if (isNew(about)) report(message())
    }

    /** Keeps [text] for the next row that has room. May be called from any thread. */
    fun note(text: String) {
        room?.texts?.add(text)
    }

    fun report(message: String) {
        StandardError.print(message)
        note(message)
    }

    fun isNew(about: String): Boolean = reported.add(about)

    fun isNewCall(about: String): Boolean = countIgnored(ignoredCalls, about)

    fun isNewName(name: String): Boolean = countIgnored(ignoredNames, name)

    private fun countIgnored(before: MutableSet<String>, about: String): Boolean {
        counters.callsIgnored.incrementAndGet()
        return before.size < MAX_MESSAGES && before.add(about)
    }
}

/** Returns [cause] as one line. Catches everything, because its `toString` may throw, too. */
internal fun describe(cause: Throwable): String = try {
    cause.toString()
} catch (_: Throwable) {
    cause.javaClass.name
}

// A limit, so that a program that invents names cannot fill the memory with them.
private const val MAX_MESSAGES = 100
