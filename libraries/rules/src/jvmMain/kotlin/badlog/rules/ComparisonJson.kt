package badlog.rules

import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.core.recording.Severity
import badlog.signals.json.JsonFields
import badlog.signals.json.jsonArray
import badlog.signals.json.jsonList
import badlog.signals.json.jsonObject

// Separate from RuleSetJson, since a page contains all code that reads that.

/** These comparisons as a line of JSON. */
internal fun comparisonsJson(comparisons: List<Comparison>): String = jsonObject(
    "comparisons" to jsonArray(comparisons) {
        jsonObject(
            "name" to quotedJson(it.name),
            "severity" to quotedJson(it.severity.name),
            "group" to quotedJson(it.group),
            "next" to quotedJson(it.next),
            "text" to quotedJson(it.text.source),
            "of" to jsonList(it.signals, ::quotedJson),
            "limits" to "[${it.deviations},${it.percent},${it.findings},${it.others}]",
        )
    },
)

/** Returns the comparisons that [comparisonsJson] wrote. */
internal fun comparisonsOf(text: String): List<Comparison> = JsonFields(JsonReader.readObject(text)).list("comparisons", ::comparisonOf)

private fun comparisonOf(value: JsonValue): Comparison {
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
