package badlog.report

import badlog.rules.Finding
import badlog.rules.SkippedRule
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** What was found in a log that can be read, and what was not looked for there, for other programs. Unknown numbers are null. */
public fun reportJson(log: LogReport): Map<String, JsonElement> = buildJsonObject {
    put("match", log.title)
    put("findings", JsonArray(log.findings.map(::findingJson)))
    put("notAsked", JsonArray(log.skipped.map(::skippedJson)))
    put("undefined", jsonOf(log.undefined))
    put("hookFailures", JsonArray(log.hookFailures.map { failureJson(it.hook, it.message) }))
}

/** A hook that failed for a log, with the reason, for other programs. */
public fun failureJson(hook: String, message: String): JsonElement = buildJsonObject {
    put("hook", hook)
    put("message", message)
}

private fun findingJson(finding: Finding): JsonElement = buildJsonObject {
    put("rule", finding.rule)
    put("severity", finding.severity.name.lowercase())
    put("topic", finding.topic)
    put("text", finding.text)
    put("time", number(finding.time))
    put("timeUnit", finding.timeUnit)
    put("spans", spansJson(finding.spans))
    put("spanCount", finding.spanCount)
    put("isOfHook", finding.isOfHook)
}

/** A rule that was skipped, for other programs. */
public fun skippedJson(skipped: SkippedRule): JsonElement = buildJsonObject {
    put("rule", skipped.rule)
    put("message", skipped.message)
    put("isMistake", skipped.isMistake)
}
