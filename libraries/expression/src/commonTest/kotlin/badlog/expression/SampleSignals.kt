package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary

/** Signals with the samples that a test gives them. */
internal class SampleSignals(
    private val samples: Map<Signal, Series>,
    private val texts: Map<String, List<String>> = emptyMap(),
    override val enabled: List<EnabledSpan>? = emptyList(),
    override val timeUnit: String = "s",
    override val rows: DoubleArray? = null,
    override val range: Span? = samples.values.mapNotNull { it.range }.takeIf { it.isNotEmpty() }
        ?.let { ranges -> Span(ranges.minOf { it.start }, ranges.maxOf { it.endInclusive }) },
) : Signals {
    override val vocabulary = Vocabulary(samples.keys.toList())

    override val axis: Series = samples.values.flatMap { it.x.toList() }.distinct().sorted().toDoubleArray().let { Series(it, it) }

    override fun series(name: String) = samples.entries.first { it.key.name == name }.value

    override fun states(name: String) = texts.getValue(name)
}

/** A vocabulary of numbers. */
internal fun names(vararg names: String) = Vocabulary(names.map { Signal(it, SignalKind.NUMBER) })

internal fun parsed(text: String, vocabulary: Vocabulary): Expression = when (val result = Expression.parse(text, vocabulary)) {
    is Expression -> result
    is ExpressionError -> throw AssertionError(result.pointed())
}

internal fun errorOf(
    text: String,
    vocabulary: Vocabulary,
): ExpressionError = when (val result = Expression.parse(text, vocabulary)) {
    is Expression -> throw AssertionError("“$text” was read as $result")
    is ExpressionError -> result
}
