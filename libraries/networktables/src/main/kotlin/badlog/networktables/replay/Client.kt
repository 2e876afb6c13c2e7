package badlog.networktables.replay

import kotlinx.serialization.json.JsonObject
import java.util.BitSet

/**
 * The subscriptions and pending values of one connected client. Use it on one thread at a time.
 *
 * @param ignore called for each request that was not understood or not performed, with a description as part of a sentence.
 */
internal class Client(
    private val player: Player,
    private val wire: Wire,
    private val frames: ValueFrames,
    private val ignore: (String) -> Unit,
) {
    private val signals = player.signals
    private val reader = RequestReader(ignore)
    private val subscriptions = Subscriptions(signals)
    private val ownTopics = OwnTopics(firstId = signals.size)
    private val outbox = Outbox(signals.size, MAX_WAITING)
    private val announced = BitSet()

    fun receive(text: String) {
        val answers = ArrayList<JsonObject>()
        for (request in reader.read(text)) {
            when (request) {
                is Request.Subscribe -> subscribe(request, answers)

                is Request.Unsubscribe -> {
                    subscriptions.remove(request.id)
                    outbox.retain(subscriptions::wantsValues)
                }

                is Request.Publish -> publish(request)?.let { answers += it }

                is Request.Unpublish -> ownTopics.unpublish(request)?.let { answers += it }

                // The recording's topics cannot be changed.
                is Request.SetProperties -> ownTopics.setProperties(request)?.let { answers += it }
            }
        }
        textFrames(answers).forEach(wire::send)
    }

    /** Queues the [updates] of subscribed topics. */
    fun offer(updates: List<Update>) {
        for (update in updates) if (subscriptions.wantsValues(update.signal)) offer(update)
    }

    /** Sends due values, unless the client has not yet received earlier ones. Returns whether all due values were sent. */
    fun flush(nowMicros: Long): Boolean {
        if (outbox.isEmpty) return true
        if (wire.isBusy) return false
        val due = outbox.take(nowMicros, MAX_AT_ONCE, subscriptions.periodMicros)
        frames.of(due).forEach(wire::send)
        return due.size < MAX_AT_ONCE
    }

    private fun offer(update: Update) {
        if (subscriptions.wantsAll(update.signal)) outbox.add(update) else outbox.replace(update)
    }

    private fun subscribe(request: Request.Subscribe, answers: MutableList<JsonObject>) {
        if (subscriptions.nameCount + request.names.size > MAX_NAMES) {
            return ignore("subscriptions to more than $MAX_NAMES names")
        }
        val matches = subscriptions.add(request)
        outbox.retain(subscriptions::wantsValues)
        for (signal in matches) {
            if (!announced.get(signal)) {
                announced.set(signal)
                answers += announcement(signal)
            }
            if (!request.isTopicsOnly) player.current(signal)?.let(::offer)
        }
    }

    private fun publish(request: Request.Publish): JsonObject? {
        val signal = subscriptions.idOf(request.name)
        if (signal != null) {
            announced.set(signal)
            return announcement(signal, request.id)
        }
        if (ownTopics.size < MAX_NAMES) return ownTopics.publish(request)
        ignore("more than $MAX_NAMES published topics")
        return null
    }

    private fun announcement(id: Int, publisher: Long? = null): JsonObject {
        val signal = signals[id]
        return announce(signal.name, id, signal.typeName, propertiesOf(signal), publisher)
    }
}

private const val MAX_NAMES = 20_000
private const val MAX_AT_ONCE = 20_000
private const val MAX_WAITING = 100_000
