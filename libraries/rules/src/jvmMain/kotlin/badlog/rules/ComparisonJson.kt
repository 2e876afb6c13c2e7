package badlog.rules

import badlog.json.JsonReader
import badlog.json.JsonValue
import badlog.json.quotedJson
import badlog.recording.Severity
import badlog.rules.json.JsonFields
import badlog.rules.json.jsonArray
import badlog.rules.json.jsonList
import badlog.rules.json.jsonObject

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
