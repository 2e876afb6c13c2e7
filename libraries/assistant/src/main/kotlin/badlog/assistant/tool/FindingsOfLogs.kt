package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Page
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.ToolException
import badlog.assistant.call.number
import badlog.assistant.log.LogFolder
import badlog.core.recording.Severity
import badlog.report.LogReport
import badlog.report.Report
import badlog.rules.BUILT_IN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.incident.Incident
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonArray
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import java.nio.file.Path

/**
 * Returns the findings of the rules in one log, or their number in each log.
 *
 * @param cache where findings are cached.
 */
internal class FindingsOfLogs(private val logs: LogFolder, private val cache: Path?) :
    AssistantTool(
        "findings",
        "Findings of rules",
        "Runs the rules (brownouts, slow loops, gaps, stuck sensors and so on). With “log”: its incidents, each with what came first and " +
            "what followed, and its findings, the worst first, with times, the topics that show it (evidence), and what to look at next. " +
            "Without “log”: for each log how many findings there are, and its incidents.",
        listOf(
            Parameter("log", ParameterType.TEXT, "The name of a log, as listed by list_logs; default: an overview of all logs."),
            Parameter("severity", ParameterType.TEXT, "The lowest severity to list: “error”, “warning” or “note”; default: note."),
        ) + Page.PARAMETERS,
    ) {
    override fun answer(arguments: Arguments): Answer {
        val name = arguments.text("log")?.let { logs.log(it).first }
        val least = arguments.text("severity")?.let(::severityOf) ?: Severity.NOTE
        val rules = logs.rules()
        // Logs are compared with each other, so all are examined.
        val all = logs.logs()
        val reports = Report(rules?.rules ?: RuleSet.BUILT_IN, cache = cache).over(all.values.toList()).logs
        val reportOf = all.keys.zip(reports)
        return Answer(
            buildJsonObject {
                rules?.problem?.let { put("rulesProblem", it) }
                if (name == null) {
                    Page.of(reportOf, arguments) { shown ->
                        shown.map { (log, report) -> overview(log, report, least) }
                    }.putInto(this, "logs")
                } else {
                    val report = reportOf.first { it.first == name }.second
                    put("log", name)
                    report.title?.let { put("match", it) }
                    report.unreadable?.let { put("unreadable", it) }
                    putJsonArray("incidents") {
                        report.incidents.filter { it.severity >= least }.take(MAX_INCIDENTS).forEach { add(json(it)) }
                    }
                    val found = report.findings.filter { it.severity >= least }
                    Page.of(found, arguments) { shown -> shown.map(::json) }.putInto(this, "findings")
                    putJsonArray("skippedRules") { report.skipped.take(MAX_SKIPPED).forEach { add(it.rule) } }
                }
            },
        )
    }

    private fun severityOf(text: String) = Severity.entries.find { it.name.equals(text, ignoreCase = true) }
        ?: throw ToolException("“severity” must be error, warning or note.")

    private fun overview(log: String, report: LogReport, least: Severity): JsonObject = buildJsonObject {
        put("log", log)
        report.title?.let { put("match", it) }
        report.unreadable?.let { put("unreadable", it) }
        for (severity in Severity.entries.reversed().filter { it >= least }) {
            put("${severity.name.lowercase()}s", report.findings.count { it.severity == severity })
        }
        putJsonArray("incidents") {
            for (incident in report.incidents.filter { it.severity >= least }.take(MAX_NAMED)) {
                addJsonObject {
                    put("name", incident.name)
                    put("time", number(incident.time))
                    put("timeUnit", incident.timeUnit)
                }
            }
        }
    }

    private fun json(incident: Incident): JsonObject = buildJsonObject {
        put("name", incident.name)
        put("severity", incident.severity.name.lowercase())
        put("time", number(incident.time))
        put("timeUnit", incident.timeUnit)
        putJsonArray("sentences") {
            for (sentence in incident.sentences.take(MAX_SENTENCES)) {
                addJsonObject {
                    put("text", sentence.text)
                    put("rule", sentence.finding.rule)
                    put("time", number(sentence.finding.time))
                    putJsonArray("evidence") { sentence.finding.evidence.take(MAX_TOPICS).forEach { add(it) } }
                }
            }
        }
        if (incident.next.isNotEmpty()) put("next", incident.next)
        incident.difference?.let { put("difference", it.text) }
    }

    private fun json(finding: Finding): JsonObject = buildJsonObject {
        put("rule", finding.rule)
        put("severity", finding.severity.name.lowercase())
        put("text", finding.text)
        put("time", number(finding.time))
        put("timeUnit", finding.timeUnit)
        put("times", finding.spanCount)
        putJsonArray("spans") {
            for (span in finding.spans.take(MAX_SPANS)) {
                addJsonArray {
                    add(number(span.from))
                    add(number(span.to))
                }
            }
        }
        putJsonArray("evidence") { finding.evidence.take(MAX_TOPICS).forEach { add(it) } }
        if (finding.next.isNotEmpty()) put("next", finding.next)
    }
}

private const val MAX_INCIDENTS = 5
private const val MAX_NAMED = 3
private const val MAX_SENTENCES = 8
private const val MAX_SPANS = 5
private const val MAX_TOPICS = 6
private const val MAX_SKIPPED = 40
