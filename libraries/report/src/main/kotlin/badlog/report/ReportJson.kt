package badlog.report

import badlog.rules.Finding
import badlog.rules.SkippedRule
import kotlinx.serialization.Serializable

/** What was found in a log that can be read, and what was skipped there, as other programs get it. Unknown numbers are null. */
@Serializable
public class ReportJson private constructor(
    private val match: String?,
    private val findings: List<FindingJson>,
    private val notAsked: List<SkippedJson>,
    private val undefined: List<UndefinedJson>,
    private val hookFailures: List<HookFailureJson>,
) {
    public constructor(log: LogReport) : this(
        log.title,
        log.findings.map(::FindingJson),
        log.skipped.map(::SkippedJson),
        log.undefined.map(::UndefinedJson),
        log.hookFailures.map { HookFailureJson(it.hook, it.message) },
    )
}

@Serializable
internal class FindingJson(
    private val rule: String,
    private val severity: String,
    private val topic: String?,
    private val text: String,
    private val time: Double?,
    private val timeUnit: String,
    private val spans: List<SpanJson>,
    private val spanCount: Int,
    private val isOfHook: Boolean,
    private val evidence: List<String>,
    private val next: String,
) {
    constructor(finding: Finding) : this(
        finding.rule,
        finding.severity.name.lowercase(),
        finding.topic,
        finding.text,
        finite(finding.time),
        finding.timeUnit,
        finding.spans.map(::SpanJson),
        finding.spanCount,
        finding.isOfHook,
        finding.evidence,
        finding.next,
    )
}

/** A rule that was skipped, as other programs get it. */
@Serializable
public class SkippedJson private constructor(private val rule: String, private val message: String, private val isMistake: Boolean) {
    public constructor(skipped: SkippedRule) : this(skipped.rule, skipped.message, skipped.isMistake)
}

/** A hook that failed for a log, and why, as other programs get it. */
@Serializable
public class HookFailureJson(private val hook: String, private val message: String)
