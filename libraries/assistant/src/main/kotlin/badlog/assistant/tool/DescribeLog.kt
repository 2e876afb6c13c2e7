package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Page
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.number
import badlog.assistant.call.unitOf
import badlog.assistant.log.OpenLog
import badlog.assistant.log.OpenLogs
import badlog.core.analysis.Span
import badlog.core.analysis.sampleRateOf
import badlog.core.analysis.statistics
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.signals.vocabulary.NamePattern
import badlog.viewer.draw.mark.ModeTimeline
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import java.math.BigDecimal
import java.math.MathContext

/** Describes the content of a log. */
internal class DescribeLog(private val logs: OpenLogs) :
    AssistantTool(
        "describe_log",
        "Describe a log",
        "Describes one log: match, x axis with unit and range, values of its header, when the robot was enabled, what is " +
            "damaged, and its topics, each with unit, kind (numeric, boolean, state, event, empty), number of samples, samples per " +
            "second (rateHz), smallest and largest value, or its states.",
        listOf(
            OpenLogs.LOG,
            Parameter("only", ParameterType.TEXT, "Only topics whose names fit this pattern, such as “PDP/*”; default: all."),
        ) + Page.PARAMETERS,
    ) {
    override fun answer(arguments: Arguments): Answer {
        val log = logs.open(arguments)
        val view = log.view
        val pattern = arguments.text("only")?.let(::NamePattern)
        val topics = view.recording.topics.filter { pattern == null || pattern.matches(it.name) }
        val page = Page.of(topics, arguments) { shown -> shown.map { json(log, it) } }
        val isFirst = arguments.whole("offset", 0, 0..Int.MAX_VALUE) == 0
        return Answer(
            buildJsonObject {
                put("log", log.name)
                put("format", view.recording.format.id)
                view.title?.let { put("match", it) }
                log.putX(this, view.xAxis.range?.let { Span(it.start, it.endInclusive) })
                if (isFirst) putRest(this, log)
                page.putInto(this, "topics")
            },
        )
    }

    /** Adds the parts that answers with later topics do not repeat. */
    private fun putRest(answer: JsonObjectBuilder, log: OpenLog) {
        val recording = log.view.recording
        answer.putJsonArray("values") {
            for (value in recording.values.take(MAX_VALUES)) {
                addJsonObject {
                    put("name", value.name)
                    put("text", value.text)
                }
            }
        }
        if (recording.values.size > MAX_VALUES) answer.put("moreValues", recording.values.size - MAX_VALUES)
        val modes = ModeTimeline.of(log.view).spans
        answer.putJsonArray("enabled") {
            for (mode in modes.take(MAX_SPANS)) {
                addJsonObject {
                    put("mode", mode.mode.title)
                    put("from", number(mode.span.from))
                    put("to", number(mode.span.to))
                }
            }
        }
        if (modes.size > MAX_SPANS) answer.put("moreEnabled", modes.size - MAX_SPANS)
        val problems = log.view.problems.sortedByDescending { it.severity }
        answer.putJsonArray("problems") {
            for (problem in problems.take(MAX_PROBLEMS)) {
                addJsonObject {
                    put("severity", problem.severity.name.lowercase())
                    put("message", problem.message)
                    put("count", problem.count)
                }
            }
        }
        if (problems.size > MAX_PROBLEMS) answer.put("moreProblems", problems.size - MAX_PROBLEMS)
    }

    private fun json(log: OpenLog, topic: Topic): JsonObject = buildJsonObject {
        put("name", topic.name)
        put("unit", unitOf(topic.unit))
        put("kind", topic.kind.name.lowercase())
        when (topic.kind) {
            TopicKind.NUMERIC, TopicKind.BOOLEAN -> {
                val statistics = log.view.seriesOf(topic).statistics()
                put("samples", statistics.count)
                if (topic.kind == TopicKind.NUMERIC) {
                    put("min", number(statistics.min))
                    put("max", number(statistics.max))
                }
            }

            TopicKind.STATE -> {
                put("samples", topic.texts.size)
                putJsonArray("states") { topic.texts.dictionary.take(MAX_STATES).forEach { add(it) } }
            }

            TopicKind.EVENT -> put("samples", topic.texts.size)

            TopicKind.EMPTY -> put("samples", 0)
        }
        val rate = log.view.sampleRateOf(topic)
        if (topic.kind == TopicKind.NUMERIC && rate.isFinite()) put("rateHz", number(roundedTo(rate, RATE_DIGITS)))
    }

    private companion object {
        const val MAX_VALUES = 60
        const val MAX_SPANS = 20
        const val MAX_PROBLEMS = 20
        const val MAX_STATES = 8
        const val RATE_DIGITS = 4

        fun roundedTo(value: Double, digits: Int): Double = BigDecimal(value).round(MathContext(digits)).toDouble()
    }
}
