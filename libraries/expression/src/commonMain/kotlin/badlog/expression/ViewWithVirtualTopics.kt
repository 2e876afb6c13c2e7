package badlog.expression

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.LogView
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.expression.samples.Stretches
import badlog.expression.signals.Signals
import badlog.expression.signals.Vocabulary

/**
 * A view with virtual topics.
 *
 * @property view the recording with a topic for each of [topics] after its own, with ordinary graphs.
 * @property topics the virtual topics, in the order of their definitions.
 * @property errors the mistakes in the other definitions, in order.
 */
class ViewWithVirtualTopics internal constructor(val view: LogView, val topics: List<VirtualTopic>, val errors: List<ExpressionError>)

/**
 * Returns this view with a topic for each of [definitions], see [VirtualTopic.parse]. A definition may use those before it. Mistakes are
 * listed, and do not affect the other definitions.
 *
 * The [metadata][badlog.core.recording.Topic.metadata] of the new topics says how they are calculated. In recordings with rows, they share
 * the rows if they have a sample in each.
 *
 * @param names the names that definitions may use: the topics of this view, possibly under additional names.
 */
fun LogView.withVirtualTopics(definitions: List<String>, names: Signals = LogViewSignals(this)): ViewWithVirtualTopics =
    VirtualTopicsDraft(this, definitions, names).run {
        do {
            val hasMore = step()
        } while (hasMore)
        extended
    }

/**
 * Builds a [ViewWithVirtualTopics] of [view] step by step, see [withVirtualTopics]. Each [step] calculates one topic, because a log may
 * have a million samples: between steps, a page can respond and a task can be canceled.
 */
class VirtualTopicsDraft(private val view: LogView, definitions: List<String>, names: Signals) {
    private val defined = DefinedTopics(names, definitions)
    private val added = ArrayList<Topic>()
    private var result = if (defined.topics.isEmpty()) ViewWithVirtualTopics(view, emptyList(), defined.errors) else null

    /** The finished share of the work, from 0 to 1. */
    val share: Double get() = added.size / (defined.topics.size + 1.0)

    /** The view, once [step] has returned false. */
    val extended: ViewWithVirtualTopics get() = checkNotNull(result)

    /** Does the next part of the work. Returns whether there was one. */
    fun step(): Boolean {
        if (result != null) return false
        val next = defined.topics.getOrNull(added.size)
        if (next == null) {
            result = ViewWithVirtualTopics(view.withTopics(view.recording.topics + added), defined.topics, defined.errors)
        } else {
            added += calculatedTopic(next, defined.signals.series(next.name), view.xAxis, defined.signals.stretches)
        }
        return true
    }
}

/** Returns this view without the topics called [names]. Calculates nothing. */
fun LogView.withoutTopics(names: Set<String>): LogView = withTopics(recording.topics.filter { it.name !in names })

private fun LogView.withTopics(topics: List<Topic>): LogView = LogView.of(recording.copy(topics = topics)).identified(title, modes)

/** Returns the mistakes in [definitions] for the topics in [names], in order. Calculates nothing, so no samples are needed. */
fun undefinedTopics(names: Signals, definitions: List<String>): List<ExpressionError> = DefinedTopics(names, definitions).errors

/** Returns the vocabulary of [names] with the topics of [definitions]. Calculates nothing, so no samples are needed. */
fun vocabularyWith(names: Signals, definitions: List<String>): Vocabulary = DefinedTopics(names, definitions).signals.vocabulary

private class DefinedTopics(names: Signals, definitions: List<String>) {
    val topics = ArrayList<VirtualTopic>()
    val errors = ArrayList<ExpressionError>()
    var signals: Signals = names
        private set

    init {
        for (definition in definitions) {
            when (val parsed = VirtualTopic.parse(definition, signals.vocabulary)) {
                is ExpressionError -> errors += parsed

                is VirtualTopic -> {
                    topics += parsed
                    signals = signals.with(parsed)
                }
            }
        }
    }
}

/**
 * Returns these signals with the virtual [topic], so that other virtual topics can use it. It may have been parsed with this vocabulary or
 * with an earlier one that this one extends.
 */
fun Signals.with(topic: VirtualTopic): Signals = SignalsWithVirtual(this, topic)

private class SignalsWithVirtual(private val others: Signals, private val topic: VirtualTopic) : Signals {
    private val samples by lazy { topic.series(others) }

    override val vocabulary: Vocabulary = others.vocabulary.with(topic.signal)

    override fun series(name: String): Series = if (name == topic.name) samples else others.series(name)

    override fun states(name: String): List<String> = others.states(name)

    override val enabled: List<EnabledSpan>? get() = others.enabled

    override val knowsAutonomous: Boolean get() = others.knowsAutonomous

    override val axis: Series get() = others.axis

    override val rows: DoubleArray? get() = others.rows

    override val range: Span? get() = others.range

    override val timeUnit: String get() = others.timeUnit

    override val stretches: Stretches? get() = others.stretches
}

/**
 * Returns the [calculated] samples of [virtual] as a topic of a recording with [xAxis]. If the recording's clock was set back, [stretches]
 * describes how.
 */
internal fun calculatedTopic(virtual: VirtualTopic, calculated: Series, xAxis: XAxis, stretches: Stretches?): Topic {
    // Topics' own times must ascend, so if the clock was set back, only rows preserve the order of samples.
    val series = stretches?.inRows(calculated, xAxis.positions) ?: calculated
    val isOfRows = series.x === xAxis.positions
    return Topic(
        virtual.name,
        virtual.unit.ifEmpty { Topic.UNITLESS },
        attributes = emptyList(),
        series.y,
        TextColumn.EMPTY,
        countsOf(series.y, virtual.expression.type.isCondition),
        // A topic without a sample needs no clock.
        times = if (isOfRows || series.size == 0) null else series.x,
        metadata = "= ${virtual.expression}",
    )
}

private fun countsOf(samples: DoubleArray, areTruthValues: Boolean): CellCounts {
    var finite = 0
    var infinite = 0
    var gaps = 0
    for (i in samples.indices) {
        val sample = samples[i]
        if (sample.isFinite()) {
            finite++
        } else {
            if (sample.isInfinite()) infinite++
            if (i == 0 || samples[i - 1].isFinite()) gaps++
        }
    }
    return CellCounts(
        numbers = if (areTruthValues) 0 else finite,
        notFinite = infinite,
        truthValues = if (areTruthValues) finite else 0,
        texts = 0,
        empty = samples.size - finite - infinite,
        gaps = gaps,
    )
}
