package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.number
import badlog.assistant.call.unitOf
import badlog.assistant.log.OpenLogs
import badlog.core.analysis.Downsampling
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.core.recording.TopicKind
import badlog.viewer.choices.range.stateRuns
import kotlinx.serialization.json.JsonArrayBuilder
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray

/** Returns the samples of topics in a range if there are few. Otherwise returns the smallest and largest of each part of the range. */
internal class SamplesOfTopics(private val logs: OpenLogs) :
    AssistantTool(
        "samples",
        "Samples of topics",
        "The samples of topics of one log in a range. If a numeric topic has more samples there than “points”, the range is divided " +
            "into that many equal parts, and the answer has the smallest and largest value of each part that has samples, so no " +
            "extreme is lost; the answer says so. For states it gives when each began and ended, for events their texts. At most " +
            "$MAX_TOPICS topics, and $MAX_POINTS points of all topics together.",
        OpenLogs.TOPICS + Parameter(
            "points",
            ParameterType.WHOLE,
            "Maximum number of points per topic, 1 to $MAX_POINTS; default $DEFAULT_POINTS.",
        ),
    ) {
    override fun answer(arguments: Arguments): Answer {
        val log = logs.open(arguments)
        val lines = log.lines(arguments, MAX_TOPICS)
        val range = log.range(arguments)
        val points = minOf(arguments.whole("points", DEFAULT_POINTS, 1..MAX_POINTS), MAX_POINTS / lines.size)
        return Answer(
            buildJsonObject {
                put("log", log.name)
                log.putX(this, range)
                put("pointsPerTopic", points)
                putJsonArray("topics") { if (range != null) lines.forEach { add(json(log.view, it, range, points)) } }
            },
        )
    }

    private fun json(view: LogView, line: GraphSeries, range: Span, points: Int): JsonObject = buildJsonObject {
        put("name", line.topic.name)
        put("unit", unitOf(line.unit))
        when {
            line.topic.kind == TopicKind.EVENT -> putEvents(view, line, range, points)
            line.states != null -> putStates(line, range, points)
            else -> putNumbers(line.data, range, points)
        }
    }

    private fun JsonObjectBuilder.putNumbers(series: Series, range: Span, points: Int) {
        val inside = (if (series.isOrdered) series.firstAtOrAfter(range.from) until series.firstAfter(range.to) else series.x.indices)
            .filter { series.x[it] in range }
        put("samplesInRange", inside.size)
        if (inside.size <= points) {
            putColumns("x", "value")
            putJsonArray("points") { for (i in inside) point(series.x[i], series.y[i]) }
            return
        }
        val parts = PixelColumns(points)
        Downsampling(series).fill(range.from, range.to, parts)
        val width = range.width / points
        put("downsampled", "the smallest and the largest value of each part")
        put("partWidth", number(width))
        putColumns("x where the part begins", "min", "max")
        putJsonArray("points") {
            for (i in 0 until points) if (parts.samples[i] > 0) point(range.from + i * width, parts.min[i], parts.max[i])
        }
    }

    private fun JsonObjectBuilder.putStates(line: GraphSeries, range: Span, points: Int) {
        val runs = line.stateRuns()
        val inside = runs.states.indices.filter { runs.from[it] <= range.to && runs.to[it] >= range.from }
        putColumns("from", "to", "state")
        putJsonArray("points") {
            for (i in inside.take(points)) {
                addJsonArray {
                    add(number(runs.from[i]))
                    add(number(runs.to[i]))
                    add(line.states.orEmpty().getOrElse(runs.states[i]) { "?" })
                }
            }
        }
        putRest(inside.drop(points).firstOrNull()?.let { runs.from[it] }, inside.size - points)
    }

    private fun JsonObjectBuilder.putEvents(view: LogView, line: GraphSeries, range: Span, points: Int) {
        val inside = view.eventsOf(line.topic).events.filter { it.x in range }
        putColumns("x", "text")
        putJsonArray("points") {
            for (event in inside.take(points)) {
                addJsonArray {
                    add(number(event.x))
                    add(event.text.take(MAX_EVENT_LENGTH))
                }
            }
        }
        putRest(inside.getOrNull(points)?.x, inside.size - points)
    }

    private fun JsonObjectBuilder.putColumns(vararg names: String) {
        putJsonArray("columns") { names.forEach { add(it) } }
    }

    /** Adds the x at which to continue with the omitted samples. */
    private fun JsonObjectBuilder.putRest(from: Double?, count: Int) {
        if (from == null) return
        put("more", count)
        put("nextFrom", number(from))
    }

    private fun JsonArrayBuilder.point(vararg numbers: Double) {
        addJsonArray { numbers.forEach { add(number(it)) } }
    }
}

private const val MAX_TOPICS = 12
private const val MAX_POINTS = 1_000
private const val DEFAULT_POINTS = 100
private const val MAX_EVENT_LENGTH = 300
