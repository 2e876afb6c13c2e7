package badlog.report.rules

import badlog.analysis.Span
import badlog.recording.Severity
import badlog.report.SpanSerializer
import kotlinx.serialization.Serializable

/**
 * A rule that holds in a log, or what a hook found there.
 *
 * @property rule the rule's name, or what the hook is called.
 * @property severity how bad it is.
 * @property topic the topic it is about; null when there is none.
 * @property text the rule's text, filled in.
 * @property time where to look first; NaN when it is about the whole log.
 * @property spans when, at most the first hundred.
 * @property spanCount how often.
 * @property timeUnit the unit of all times, empty where x has none.
 * @property isOfHook whether a hook found it, and no rule.
 */
@Serializable
public class Finding internal constructor(
    public val rule: String,
    public val severity: Severity,
    public val topic: String?,
    public val text: String,
    public val time: Double,
    public val spans: List<
        @Serializable(with = SpanSerializer::class)
        Span,
        >,
    public val spanCount: Int,
    public val timeUnit: String,
    public val isOfHook: Boolean = false,
)
