package badlog.report

import badlog.catalog.examine.UndefinedTopic
import badlog.core.analysis.Span
import badlog.expression.ExpressionError
import badlog.expression.Quantity
import kotlinx.serialization.Serializable

/** The result of a question for a readable log, in the form for other programs. Unknown and non-finite numbers are null. */
@Serializable
class FindJson private constructor(
    private val match: String?,
    private val outcome: String,
    private val time: Double?,
    private val timeUnit: String?,
    private val figures: List<QuantityJson>,
    private val spans: List<SpanJson>,
    private val spanCount: Int?,
    private val reason: String?,
    private val topic: String?,
    private val message: String?,
    private val undefined: List<UndefinedJson>,
    private val occurrences: List<OccurrenceJson>,
    private val implausible: List<ImplausibleJson>,
) {
    private constructor(result: FindResult, answered: Reply.Answered?, refused: Reply.NotAsked?) : this(
        match = result.title,
        outcome = answered?.outcome?.name?.lowercase() ?: if (result.reply is Reply.LeftOut) "left_out" else "not_asked",
        time = finite(answered?.time),
        timeUnit = answered?.timeUnit,
        figures = answered?.quantities.orEmpty().map(::QuantityJson),
        spans = answered?.spans.orEmpty().map(::SpanJson),
        spanCount = answered?.spanCount,
        reason = refused?.kind?.name?.lowercase(),
        topic = refused?.topic,
        message = refused?.message ?: answered?.reason,
        undefined = result.undefined.map(::UndefinedJson),
        occurrences = answered?.occurrences.orEmpty().map(::OccurrenceJson),
        implausible = answered?.implausible.orEmpty().map { (topic, samples) -> ImplausibleJson(topic, samples) },
    )

    constructor(result: FindResult) : this(result, result.reply as? Reply.Answered, result.reply as? Reply.NotAsked)
}

@Serializable
internal class QuantityJson(private val name: String, private val value: Double?, private val unit: String, private val time: Double?) {
    constructor(quantity: Quantity) : this(quantity.name, finite(quantity.value), quantity.unit, finite(quantity.time))
}

/** The number of samples of a topic that were left out, since no robot has such values. */
@Serializable
internal class ImplausibleJson(private val topic: String, private val samples: Int)

/** An occurrence, in the form for other programs. */
@Serializable
internal class OccurrenceJson private constructor(
    private val from: Double?,
    private val to: Double?,
    private val before: Map<String, String>,
) {
    constructor(occurrence: Reply.Occurrence) :
        this(finite(occurrence.span.from), finite(occurrence.span.to), occurrence.before.toMap())
}

@Serializable
internal class SpanJson(private val from: Double?, private val to: Double?) {
    constructor(span: Span) : this(finite(span.from), finite(span.to))
}

/** A virtual topic that could not be calculated for a log, in the form for other programs. */
@Serializable
class UndefinedJson private constructor(private val definition: String, private val message: String) {
    constructor(topic: UndefinedTopic) : this(topic.definition, topic.message)

    constructor(error: ExpressionError) : this(UndefinedTopic(error))
}

/** Returns [value] if it is finite, otherwise null: JSON has only finite numbers. */
internal fun finite(value: Double?): Double? = value?.takeIf { it.isFinite() }
