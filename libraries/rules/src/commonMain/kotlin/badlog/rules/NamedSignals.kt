package badlog.rules

import badlog.analysis.Series
import badlog.expression.signals.Signal
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary

/** [signal] under the name [name], its numbers times [scale] in [unit]. */
internal class NamedSignal(val name: String, val signal: Signal, val scale: Double, unit: String) {
    /** How a vocabulary lists it. */
    val listed = Signal(name, signal.kind, unit)
}

/**
 * The signals of a log, and some of them under further names.
 *
 * @param clock gives the samples of [CLOCK], if that is among [named].
 */
internal class NamedSignals(
    private val log: Signals,
    private val named: Map<String, NamedSignal>,
    override val vocabulary: Vocabulary,
    private val clock: () -> Series,
) : Signals by log {
    private val scaled = HashMap<String, Series>()

    override fun series(name: String): Series {
        val named = named[name] ?: return log.series(name)
        val series = if (named.signal === CLOCK) clock() else log.series(named.signal.name)
        if (named.scale == 1.0) return series
        return scaled.getOrPut(name) { Series(series.x, DoubleArray(series.size) { series.y[it] * named.scale }) }
    }

    override fun states(name: String): List<String> = log.states(named[name]?.signal?.name ?: name)
}

/** These signals' names after those of [named], which go first. */
internal fun Vocabulary.with(named: Collection<NamedSignal>): Vocabulary = Vocabulary(named.map { it.listed } + signals, hasTime)
