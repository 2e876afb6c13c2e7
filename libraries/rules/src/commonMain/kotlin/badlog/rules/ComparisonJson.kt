package badlog.rules

import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.core.recording.Severity
import badlog.signals.json.JsonFields
import badlog.signals.json.jsonList
import badlog.signals.json.jsonObject

/** Returns [comparison] as JSON. */
internal fun comparisonJson(comparison: Comparison): String = with(comparison) {
    jsonObject(
        "name" to quotedJson(name),
        "severity" to quotedJson(severity.name),
        "group" to quotedJson(group),
        "next" to quotedJson(next),
        "text" to quotedJson(text.source),
        "of" to jsonList(signals, ::quotedJson),
        "limits" to "[$deviations,$percent,$findings,$others]",
    )
}

/** Returns the comparison that [comparisonJson] wrote. */
internal fun comparisonOf(value: JsonValue): Comparison {
    val json = JsonFields(value.members)
    val (deviations, percent, findings, others) = json.list("limits") { it.json.toDouble() }
    return Comparison(
        name = json.string("name"),
        severity = Severity.valueOf(json.string("severity")),
        group = json.string("group"),
        next = json.string("next"),
        text = RuleText.parse(json.string("text"), Comparison.PLACES),
        signals = json.strings("of"),
        deviations = deviations,
        percent = percent,
        findings = findings.toInt(),
        others = others.toInt(),
    )
}
