package badlog.cli.info

import badlog.files.terminal.TextTable
import badlog.files.terminal.TextTable.Column
import badlog.signals.vocabulary.SignalTopic
import kotlinx.serialization.Serializable

/**
 * Returns the topics that were recognized as signals, with the reasons, in lines of [width] columns. Without a limit, names are not
 * shortened.
 */
internal fun signalLines(signals: List<SignalTopic>, width: Int): List<String> {
    if (signals.isEmpty()) return listOf("No topic matches a known signal; docs/signals.md explains how to name yours.")
    val rows = signals.groupBy { Triple(it.signal, it.unit, it.reason) }.values.flatMap { alike ->
        val isLong = alike.size > MAX_ALIKE
        val more = if (isLong) "; ${alike.size - 1} more like it" else ""
        (if (isLong) alike.take(1) else alike).map { listOf(it.signal, it.topic, it.unit, it.reason + more) }
    }
    return TextTable(COLUMNS, width).lines(rows).flatten()
}

/** A topic that was recognized as a signal, for programs. */
@Serializable
internal class SignalJson private constructor(
    private val signal: String,
    private val topic: String,
    private val unit: String,
    private val reason: String,
) {
    constructor(topic: SignalTopic) : this(topic.signal, topic.topic, topic.unit, topic.reason)
}

/** The most similar topics to list. More, such as the channels of a power distribution or the buttons of a controller, are shortened to one. */
private const val MAX_ALIKE = 3

private val COLUMNS = listOf("SIGNAL", "TOPIC", "UNIT", "WHY").map { Column(it) }
