package badlog.cli.info

import badlog.cli.text.JsonNumber
import badlog.cli.text.ProblemJson
import badlog.core.analysis.Units
import badlog.core.analysis.XAxis
import badlog.core.recording.CellCounts
import badlog.core.recording.Value
import badlog.expression.ExpressionError
import badlog.report.UndefinedJson
import badlog.signals.vocabulary.SignalTopic
import kotlinx.serialization.Serializable

/** Everything about one log, for programs. */
@Serializable
internal class InfoJson private constructor(
    private val format: String,
    private val bytes: Long,
    private val match: String?,
    private val rows: Int,
    private val x: AxisJson,
    private val values: List<ValueJson>,
    private val topics: List<TopicJson>,
    private val signals: List<SignalJson>,
    private val problems: List<ProblemJson>,
    private val undefined: List<UndefinedJson>,
) {
    /** Creates the JSON of the log in [summary] with these [signals]. Virtual topics with [errors] could not be added to it. */
    constructor(summary: LogSummary, signals: List<SignalTopic>, errors: List<ExpressionError>) : this(
        summary.view.recording.format.id,
        summary.bytes,
        summary.view.title,
        summary.view.recording.rowCount,
        AxisJson(summary.view.xAxis, summary),
        summary.view.recording.values.map(::ValueJson),
        summary.topics.map(::TopicJson),
        signals.map(::SignalJson),
        summary.view.problems.map(::ProblemJson),
        errors.map(::UndefinedJson),
    )
}

@Serializable
private class AxisJson(
    private val name: String,
    private val topic: String?,
    private val unit: String?,
    private val from: JsonNumber?,
    private val to: JsonNumber?,
    private val seconds: JsonNumber?,
) {
    constructor(axis: XAxis, summary: LogSummary) :
        this(axis.name, axis.topic?.name, unitOf(axis.unit), summary.range?.start, summary.range?.endInclusive, summary.seconds)
}

@Serializable
private class ValueJson(private val name: String, private val text: String) {
    constructor(value: Value) : this(value.name, value.text)
}

@Serializable
private class TopicJson(
    private val name: String,
    private val unit: String?,
    private val kind: String,
    private val sparse: Boolean,
    private val attributes: List<String>,
    private val count: Int,
    private val rate: JsonNumber?,
    private val min: JsonNumber,
    private val max: JsonNumber,
    private val texts: Int,
    private val gaps: Int?,
    private val cells: CellsJson,
) {
    constructor(summary: TopicSummary) : this(
        summary.topic.name,
        unitOf(summary.topic.unit),
        summary.topic.kind.name.lowercase(),
        summary.topic.isSparse,
        summary.topic.attributes,
        summary.count,
        summary.rate,
        summary.min,
        summary.max,
        summary.topic.texts.dictionary.size,
        summary.gaps,
        CellsJson(summary.topic.counts),
    )
}

@Serializable
private class CellsJson(
    private val numbers: Int,
    private val notFinite: Int,
    private val truthValues: Int,
    private val texts: Int,
    private val empty: Int,
) {
    constructor(counts: CellCounts) : this(counts.numbers, counts.notFinite, counts.truthValues, counts.texts, counts.empty)
}

private fun unitOf(unit: String): String? = unit.takeUnless(Units::isNone)
