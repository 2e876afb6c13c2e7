package badlog.cli.info

import badlog.rules.signal.SignalTopic
import badlog.terminal.TextTable
import badlog.terminal.TextTable.Column
import kotlinx.serialization.Serializable

/** Which topic was taken for what, and why, in lines that fit a terminal. */
internal fun signalLines(signals: List<SignalTopic>): List<String> {
    if (signals.isEmpty()) return listOf("No topic is a signal that badlog knows; docs/signals.md says how to name yours.")
    return TABLE.lines(signals.map { listOf(it.signal, it.topic, it.unit, it.reason) }).flatten()
}

/** A topic that was taken for a signal, for a program. */
@Serializable
internal class SignalJson private constructor(
    private val signal: String,
    private val topic: String,
    private val unit: String,
    private val reason: String,
) {
    constructor(topic: SignalTopic) : this(topic.signal, topic.topic, topic.unit, topic.reason)
}

private val TABLE = TextTable(listOf(Column("SIGNAL", 16), Column("TOPIC", 24), Column("UNIT", 5), Column("WHY")))
