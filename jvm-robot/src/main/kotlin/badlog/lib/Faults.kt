package badlog.lib

import java.util.concurrent.ConcurrentHashMap

/**
 * Where everything goes that went wrong in a robot's loop: counted each time, said once by [StandardError], and noted as
 * an event in the log if that has [room] for events. Never throws.
 *
 * Texts are made only when they are said: what goes wrong in each loop is not to make garbage in each.
 */
internal class Faults(val counters: Counters) {
    // Three, because the names that a program makes up must neither meet each other nor the log's own subjects.
    private val said = ConcurrentHashMap.newKeySet<String>()
    private val ignoredCalls = ConcurrentHashMap.newKeySet<String>()
    private val ignoredNames = ConcurrentHashMap.newKeySet<String>()

    /** The column that takes events, if there is one. */
    @Volatile
    var room: EventSink? = null

    /** The cell of [topic] stays empty in this row. */
    fun cellMissed(topic: Topic, cause: Throwable) = cellMissed(topic) { "threw ${describe(cause)}" }

    inline fun cellMissed(topic: Topic, what: () -> String) {
        counters.cellsMissed.incrementAndGet()
        if (topic.isFaultSaid) return
        topic.isFaultSaid = true
        say("The topic \"${topic.name}\" ${what()}, so its cell is empty. Further gaps of this topic are only counted.")
    }

    /** A call was not followed. [about] tells apart what is said once each. */
    inline fun callIgnored(about: String, why: () -> String) {
        if (isNewCall(about)) say(why())
    }

    /** What was published to [name] was not taken. */
    inline fun publishIgnored(name: String?, why: () -> String) {
        if (isNewName(name ?: "")) say(why())
    }

    /** Says [message], unless something was said about [about] before: one of the log's own few subjects. */
    inline fun sayOnce(about: String, message: () -> String) {
        if (isNew(about)) say(message())
    }

    /** Keeps [text] for the next row that has room. May be called by any thread. */
    fun note(text: String) {
        room?.texts?.add(text)
    }

    fun say(message: String) {
        StandardError.say(message)
        note(message)
    }

    fun isNew(about: String): Boolean = said.add(about)

    fun isNewCall(about: String): Boolean = isCountedNew(ignoredCalls, about)

    fun isNewName(name: String): Boolean = isCountedNew(ignoredNames, name)

    private fun isCountedNew(before: MutableSet<String>, about: String): Boolean {
        counters.callsIgnored.incrementAndGet()
        return before.size < MAX_MESSAGES && before.add(about)
    }

    private companion object {
        // A program that makes up names must not fill the memory with them.
        const val MAX_MESSAGES = 100
    }
}

/** [cause] in one line. Its own text may throw, too. */
internal fun describe(cause: Throwable): String = try {
    cause.toString()
} catch (_: Throwable) {
    cause.javaClass.name
}
