package badlog.report

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** [result] as one JSON object for other programs: all logs, also those in which nothing was found. Unknown numbers are null. */
public fun reportJson(result: ReportResult): String = PRETTY.encodeToString(
    JsonObject.serializer(),
    buildJsonObject {
        put("logs", JsonArray(result.logs.map(::logJson)))
        put(
            "skipped",
            buildJsonArray {
                for (skipped in result.skipped) {
                    addJsonObject {
                        put("rule", skipped.rule)
                        put("logs", skipped.logs)
                        put("message", skipped.message)
                        put("isMistake", skipped.isMistake)
                    }
                }
            },
        )
    },
)

private fun logJson(log: LogReport): JsonElement = buildJsonObject {
    put("file", log.file.path.toString())
    put("match", log.title)
    if (log.unreadable != null) put("unreadable", log.unreadable)
    if (log.undefined.isNotEmpty()) put("undefined", undefinedJson(log.undefined))
    if (log.hookFailures.isNotEmpty()) {
        put(
            "hookFailures",
            buildJsonArray {
                for (failure in log.hookFailures) {
                    addJsonObject {
                        put("hook", failure.hook)
                        put("message", failure.message)
                    }
                }
            },
        )
    }
    put(
        "findings",
        buildJsonArray {
            for (finding in log.findings) {
                addJsonObject {
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
            }
        },
    )
}
