package badlog.report.rules

import badlog.plot.Span
import badlog.recording.Severity
import badlog.report.SpanSerializer
import kotlinx.serialization.Serializable

/**
 * A rule that holds in a log.
 *
 * @property rule the rule's name.
 * @property severity the rule's severity.
 * @property topic the topic it is about; null when there is none.
 * @property text the rule's text, filled in.
 * @property time where to look first; NaN when it holds for the whole log alone.
 * @property spans when it holds, the first hundred of [spanCount].
 * @property timeUnit the unit of all times, empty where x has none.
 */
@Serializable
public class Finding internal constructor(
    public val rule: String,
    public val severity: Severity,
    public val topic: String?,
    public val text: String,
    public val time: Double,
    public val spans: List<@Serializable(with = SpanSerializer::class) Span>,
    public val spanCount: Int,
    public val timeUnit: String,
)
