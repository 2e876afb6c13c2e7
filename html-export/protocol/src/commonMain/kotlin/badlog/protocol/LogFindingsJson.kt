package badlog.protocol

import badlog.core.analysis.Span
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.LogFindings
import badlog.rules.SkippedRule
import badlog.rules.standing.PROVEN_TRUST

/** Returns these findings as JSON, the form in which the page's worker passes them on. */
fun LogFindings.toJson(): String = jsonObject(
    "findings" to array(findings, ::findingJson),
    "skipped" to array(skipped) {
        jsonObject(
            "rule" to quotedJson(it.rule),
            "logs" to it.logs.toString(),
            "message" to quotedJson(it.message),
            "isMistake" to it.isMistake.toString(),
            "lacking" to it.lacking?.let(::quotedJson),
            "simulated" to it.simulated?.let(::quotedJson),
        )
    },
    "ran" to ran.toString(),
)

/** Returns the findings in [text], or null if [LogFindings.toJson] did not write it. */
fun logFindingsOf(text: String): LogFindings? = unlessMalformed {
    val json = JsonFields(JsonReader.readObject(text))
    LogFindings(
        json.list("findings", ::findingOf),
        json.list("skipped") { skipped ->
            val fields = JsonFields(skipped.members)
            SkippedRule(
                fields["rule"].string,
                fields["logs"].number.toInt(),
                fields["message"].string,
                fields["isMistake"].boolean,
                lacking = fields.find("lacking")?.string,
                simulated = fields.find("simulated")?.string,
            )
        },
        json["ran"].number.toInt(),
    )
}

/** Returns [finding] as JSON. Times that are not finite are omitted, and read back as NaN. */
internal fun findingJson(finding: Finding): String = jsonObject(
    "rule" to quotedJson(finding.rule),
    "severity" to quotedJson(finding.severity.name.lowercase()),
    "topic" to finding.topic?.let(::quotedJson),
    "text" to quotedJson(finding.text),
    "time" to finding.time.takeIf { it.isFinite() }?.toString(),
    "spans" to array(finding.spans.filter { it.from.isFinite() && it.to.isFinite() }) { "[${it.from},${it.to}]" },
    "spanCount" to finding.spanCount.toString(),
    "timeUnit" to quotedJson(finding.timeUnit),
    "isOfHook" to finding.isOfHook.toString(),
    "evidence" to array(finding.evidence, ::quotedJson),
    "next" to finding.next.takeIf { it.isNotEmpty() }?.let(::quotedJson),
    "caveats" to finding.caveats.takeIf { it.isNotEmpty() }?.let { array(it, ::quotedJson) },
    "isForEach" to "true".takeIf { finding.isForEach },
    "trust" to finding.trust.takeIf { it < PROVEN_TRUST }?.toString(),
    "texts" to finding.texts.takeIf { it.isNotEmpty() }?.let { array(it, ::quotedJson) },
    "meanwhile" to finding.meanwhile.takeIf { it.isNotEmpty() }?.let { array(it, ::quotedJson) },
)

internal fun findingOf(value: JsonValue): Finding {
    val json = JsonFields(value.members)
    val severity = json["severity"].string
    return Finding(
        rule = json["rule"].string,
        severity = Severity.entries.find { it.name.lowercase() == severity } ?: malformed(),
        topic = json.find("topic")?.string,
        text = json["text"].string,
        time = json.find("time")?.number ?: Double.NaN,
        spans = json.list("spans") { span ->
            val (from, to) = span.items ?: malformed()
            Span(from.number, to.number)
        },
        spanCount = json["spanCount"].number.toInt(),
        timeUnit = json["timeUnit"].string,
        isOfHook = json["isOfHook"].boolean,
        evidence = json.list("evidence") { it.string },
        next = json.find("next")?.string.orEmpty(),
        caveats = if (json.find("caveats") == null) emptyList() else json.list("caveats") { it.string },
        isForEach = json.find("isForEach")?.boolean == true,
        trust = json.find("trust")?.number ?: PROVEN_TRUST,
        texts = if (json.find("texts") == null) emptyList() else json.list("texts") { it.string },
        meanwhile = if (json.find("meanwhile") == null) emptyList() else json.list("meanwhile") { it.string },
    )
}
