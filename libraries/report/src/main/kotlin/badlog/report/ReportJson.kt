package badlog.report

import badlog.rules.Finding
import badlog.rules.NotLookedAt
import badlog.rules.SkippedRule
import badlog.rules.incident.Incident
import kotlinx.serialization.Serializable

/** The findings and skipped rules of a readable log, in the form for other programs. Unknown numbers are null. */
@Serializable
class ReportJson private constructor(
    private val match: String?,
    private val incidents: List<IncidentJson>,
    private val findings: List<FindingJson>,
    private val notAsked: List<SkippedJson>,
    private val notLookedAt: NotLookedAtJson,
    private val undefined: List<UndefinedJson>,
    private val hookFailures: List<HookFailureJson>,
    private val batteryResistance: ResistanceJson?,
) {
    constructor(log: LogReport) : this(
        log.title,
        log.incidents.map(::IncidentJson),
        log.findings.map(::FindingJson),
        log.skipped.map(::SkippedJson),
        NotLookedAtJson(log.notLookedAt),
        log.undefined.map(::UndefinedJson),
        log.hookFailures.map { HookFailureJson(it.hook, it.message) },
        log.numbers.takeUnless { it.resistance.isNaN() }?.let { ResistanceJson(it.resistance, it.uncertainty) },
    )
}

/** The resistance of battery and wiring, and its uncertainty (95 %). */
@Serializable
internal class ResistanceJson(private val milliohms: Double, private val uncertainty: Double)

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
    private val caveats: List<String>,
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
        finding.caveats,
    )
}

/** An incident: its description in sentences with evidence, and the rules that found its causes and effects. */
@Serializable
internal class IncidentJson(
    private val name: String,
    private val severity: String,
    private val time: Double?,
    private val timeUnit: String,
    private val sentences: List<SentenceJson>,
    private val causes: List<String>,
    private val effects: List<String>,
    private val next: String,
    private val difference: String?,
) {
    constructor(incident: Incident) : this(
        incident.name,
        incident.severity.name.lowercase(),
        finite(incident.time),
        incident.timeUnit,
        incident.sentences.map(::SentenceJson),
        incident.causes.map { it.rule }.distinct(),
        incident.effects.map { it.rule }.distinct(),
        incident.next,
        incident.difference?.text,
    )
}

@Serializable
internal class SentenceJson(
    private val text: String,
    private val rule: String,
    private val time: Double?,
    private val evidence: List<String>,
) {
    constructor(sentence: Incident.Sentence) :
        this(sentence.text, sentence.finding.rule, finite(sentence.finding.time), sentence.finding.evidence)
}

/** A skipped rule, in the form for other programs. */
@Serializable
class SkippedJson private constructor(private val rule: String, private val message: String, private val isMistake: Boolean) {
    constructor(skipped: SkippedRule) : this(skipped.rule, skipped.message, skipped.isMistake)
}

/** The numbers of rules that ran and were skipped for a log, and the missing signals, in the form for other programs. */
@Serializable
internal class NotLookedAtJson(
    private val rulesRan: Int,
    private val rulesSkipped: Int,
    private val lacking: List<String>,
    private val text: String,
    private val howToLog: Map<String, Map<String, String>>,
) {
    constructor(unseen: NotLookedAt) : this(unseen.ran, unseen.skippedCount, unseen.lacking, unseen.text, howToLogAll(unseen.lacking))
}

/** A hook that failed for a log, with the reason, in the form for other programs. */
@Serializable
class HookFailureJson(private val hook: String, private val message: String)
