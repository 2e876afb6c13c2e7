package badlog.rules

import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.jsonList
import badlog.signals.json.jsonObject

internal fun comparisonJson(comparison: ComparisonRule): String = with(comparison) {
    jsonObject(
        "name" to quotedJson(name),
        "severity" to quotedJson(severity.name),
        "group" to quotedJson(group),
        "next" to quotedJson(next),
        "text" to quotedJson(text.source),
        "of" to jsonList(signals, ::quotedJson),
        "limits" to "[$deviations,$percent,$findings,$others]",
        "trust" to trustJson(trust),
    )
}

/** Returns the comparison that [comparisonJson] wrote. */
internal fun comparisonOf(value: JsonValue): ComparisonRule {
    val json = JsonFields(value.members)
    val limits = json.list("limits", ::limitOf)
    if (limits.size != ComparisonRule.LIMITS.size) throw UnreadableJsonException()
    val (deviations, percent, findings, others) = limits
    return ComparisonRule(
        name = json.string("name"),
        severity = severityOf(json.string("severity")),
        group = json.string("group"),
        next = json.string("next"),
        text = textOf(json.string("text"), ComparisonRule.PLACES),
        signals = json.strings("of"),
        deviations = deviations,
        percent = percent,
        findings = findings.toInt(),
        others = others.toInt().coerceAtLeast(ComparisonRule.MIN_OTHERS),
        trust = json.trust(),
    )
}

private fun limitOf(value: JsonValue): Double = value.json.toDoubleOrNull()?.takeIf { it >= 0 } ?: throw UnreadableJsonException()
