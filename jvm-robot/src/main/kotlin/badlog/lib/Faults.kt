package badlog.lib

import java.util.concurrent.ConcurrentHashMap

/**
 * Where everything goes that went wrong in a robot's loop: counted each time, said once on standard error, and noted as
 * an event in the log if that has [room] for events. Never throws.
 */
internal class Faults(val counters: Counters) {
    private val said = ConcurrentHashMap.newKeySet<String>()

    /** The column that takes events, if there is one. */
    @Volatile
    var room: EventRoom? = null

    /** The cell of [topic] stays empty in this row. */
    fun cellMissed(topic: Topic, cause: Throwable) = cellMissed(topic, "threw ${describe(cause)}")

    fun cellMissed(topic: Topic, what: String) {
        counters.cellsMissed.incrementAndGet()
        if (topic.isFaultSaid) return
        topic.isFaultSaid = true
        say("The topic \"${topic.name}\" $what, so its cell is empty. Further gaps of this topic are only counted.")
    }

    /** A call was not followed. [about] tells apart what is said once each. */
    fun callIgnored(about: String, why: String) {
        counters.callsIgnored.incrementAndGet()
        sayOnce(about, why)
    }

    /** Says [message], unless something was said about [about] before. */
    fun sayOnce(about: String, message: String) {
        if (said.size < MOST_MESSAGES && said.add(about)) say(message)
    }

    private fun say(message: String) {
        sayAboutBadLog(message)
        room?.note(message)
    }

    private companion object {
        // A program that makes up names must not fill the memory with them.
        const val MOST_MESSAGES = 100
    }
}

/** Writes [message] to standard error as badlog's. */
internal fun sayAboutBadLog(message: String) = System.err.println("badlog: $message")

/** [cause] in one line. Its own text may throw, too. */
internal fun describe(cause: Throwable): String = try {
    cause.toString()
} catch (_: Throwable) {
    cause.javaClass.name
}
