package badlog.expression

import badlog.analysis.EnabledSpan
import badlog.analysis.Series
import badlog.analysis.Span

/**
 * These signals and the virtual [topic], which may have been read with the vocabulary of either this or what this was made
 * from. So one virtual topic can be made of others.
 */
public fun Signals.with(topic: VirtualTopic): Signals = SignalsWithVirtual(this, topic)

private class SignalsWithVirtual(private val others: Signals, private val topic: VirtualTopic) : Signals {
    private val samples by lazy { topic.series(others) }

    override val vocabulary: Vocabulary = others.vocabulary.run { Vocabulary(signals + topic.signal, hasTime) }

    override fun series(name: String): Series = if (name == topic.name) samples else others.series(name)

    override fun states(name: String): List<String> = others.states(name)

    override val enabled: List<EnabledSpan> get() = others.enabled

    override val range: Span? get() = others.range

    override val timeUnit: String get() = others.timeUnit

    override val stretches: Stretches? get() = others.stretches
}
