package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.number
import badlog.assistant.call.unitOf
import badlog.assistant.log.OpenLogs
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.statistics
import badlog.viewer.choices.range.stateRuns
import badlog.viewer.shown.statistics.StateTime
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.shown.statistics.timesOf
import badlog.viewer.text.numberText
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import kotlinx.serialization.json.putJsonObject

/** Calculates statistics of topics over a range. */
internal class StatisticsOfTopics(private val logs: OpenLogs) :
    AssistantTool(
        "statistics",
        "Statistics of topics",
        "Statistics of topics of one log over a range: min, max, mean, median, percentiles, standard deviation, first, last, change, " +
            "integral, number of samples and of gaps; for states how long and how often each was active. Mean, median, percentiles and " +
            "standard deviation are by time.",
        OpenLogs.TOPICS,
    ) {
    override fun answer(arguments: Arguments): Answer {
        val log = logs.open(arguments)
        val lines = log.lines(arguments, MAX_TOPICS)
        val range = log.range(arguments)
        return Answer(
            buildJsonObject {
                put("log", log.name)
                log.putX(this, range)
                putJsonArray("topics") {
                    if (range != null) {
                        lines.forEach { add(if (it.states == null) numbers(log.view, it, range) else states(log.view, it, range)) }
                    }
                }
            },
        )
    }

    private fun numbers(view: LogView, line: GraphSeries, range: Span): JsonObject = buildJsonObject {
        put("name", line.topic.name)
        val statistics = line.statistics(range.from, range.to)
        for (statistic in Statistic.entries) {
            putJsonObject(statistic.title) {
                // Without insignificant digits.
                put("value", number(numberText(statistic.of(statistics)).toDoubleOrNull()))
                put("unit", unitOf(statistic.unitOf(line.unit, view.xAxis.unit)))
            }
        }
    }

    private fun states(view: LogView, line: GraphSeries, range: Span): JsonObject = buildJsonObject {
        put("name", line.topic.name)
        val runs = line.stateRuns()
        val times = runs.timesOf(line.states.orEmpty(), listOf(range))
        put("timeUnit", unitOf(view.xAxis.unit))
        putJsonArray("states") {
            for (time in times.take(StateTime.MAX_LISTED)) {
                addJsonObject {
                    put("state", time.state)
                    put("time", number(numberText(time.time).toDoubleOrNull()))
                    put("share", number(numberText(time.share).toDoubleOrNull()))
                    put("times", time.count)
                }
            }
        }
        if (times.size > StateTime.MAX_LISTED) put("moreStates", times.size - StateTime.MAX_LISTED)
    }
}

private const val MAX_TOPICS = 12
