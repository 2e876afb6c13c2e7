package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Page
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.ToolException
import badlog.assistant.call.number
import badlog.assistant.call.unitOf
import badlog.assistant.log.LogFolder
import badlog.report.Find
import badlog.report.FindResult
import badlog.report.Reply
import badlog.report.mistakeIn
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonArray
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import kotlinx.serialization.json.putJsonObject
import java.nio.file.Path

/**
 * Evaluates a question for one log or for all.
 *
 * @param cache where answers are cached.
 */
internal class FindInLogs(private val logs: LogFolder, private val cache: Path?) :
    AssistantTool(
        "find",
        "Evaluate an expression",
        "Evaluates an expression for one log or all: “min(battery voltage) < 7 for 0.1 s”, “max(total current)”, " +
            "“each(Browned Out, Battery Voltage, Total Current)”, “count(Event Log contains 'CAN')”, “min(Battery Voltage) lowest 3”. " +
            LANGUAGE,
        listOf(
            Parameter("question", ParameterType.TEXT, "The expression.", isRequired = true),
            Parameter("log", ParameterType.TEXT, "The name of a log, as listed by list_logs; default: all logs."),
            Parameter(
                "formulas",
                ParameterType.TEXTS,
                "Topics to calculate first, each such as “Power [W] = Battery Voltage * Total Current”.",
            ),
        ) + Page.PARAMETERS,
    ) {
    override fun answer(arguments: Arguments): Answer {
        val find = Find(arguments.requiredText("question"), arguments.texts("formulas"), cache, signals = logs.signals())
        find.mistake?.let { throw ToolException(it.pointed) }
        val asked = arguments.text("log")?.let { listOf(logs.log(it)) } ?: logs.logs().toList()
        val nameOf = asked.associate { (name, file) -> file to name }
        val results = find.over(asked.map { it.second })
        mistakeIn(results)?.let { throw ToolException(it.pointed) }
        // A log excluded by the question is not a result.
        val shown = results.filter { it.reply !is Reply.LeftOut && (it.reply as? Reply.Unreadable)?.isNoLog != true }
        return Answer(
            buildJsonObject {
                Page.of(shown, arguments) { part -> part.map { json(nameOf.getValue(it.file), it) } }.putInto(this, "answers")
                if (shown.size < results.size) put("leftOut", results.size - shown.size)
            },
        )
    }

    private fun json(name: String, result: FindResult): JsonObject = buildJsonObject {
        put("log", name)
        result.title?.let { put("match", it) }
        if (result.isSalvaged) put("isDamaged", true)
        when (val reply = result.reply) {
            is Reply.Answered -> put(this, reply)
            is Reply.NotAsked -> put("notAsked", reply.message)
            is Reply.Unreadable -> put("unreadable", reply.message)
            Reply.LeftOut -> Unit
        }
    }

    private fun put(answer: JsonObjectBuilder, reply: Reply.Answered) {
        answer.put("outcome", reply.outcome.name.lowercase())
        answer.put("time", number(reply.time))
        answer.put("timeUnit", reply.timeUnit)
        answer.putJsonArray("values") {
            for (quantity in reply.quantities.take(MAX_QUANTITIES)) {
                addJsonObject {
                    put("name", quantity.name)
                    put("value", number(quantity.value))
                    put("unit", unitOf(quantity.unit))
                    put("time", number(quantity.time))
                }
            }
        }
        if (reply.spanCount > 0) {
            answer.put("times", reply.spanCount)
            answer.putJsonArray("spans") {
                for (span in reply.spans.take(MAX_SPANS)) {
                    addJsonArray {
                        add(number(span.from))
                        add(number(span.to))
                    }
                }
            }
        }
        if (reply.occurrences.isNotEmpty()) {
            answer.putJsonArray("occurrences") {
                for (occurrence in reply.occurrences.take(MAX_SPANS)) {
                    addJsonObject {
                        put("from", number(occurrence.span.from))
                        put("to", number(occurrence.span.to))
                        putJsonObject("before") { occurrence.before.take(MAX_QUANTITIES).forEach { (topic, text) -> put(topic, text) } }
                    }
                }
            }
        }
        reply.reason?.let { answer.put("reason", it) }
    }

    internal companion object {
        /** A description of expressions for assistants. */
        const val LANGUAGE: String =
            "Names are those of topics or signals; put texts in single quotes; numbers may have units (7 V, 0.5 s). Operators: and or " +
                "not < <= > >= == != contains matches + - * / ^, “x when c”, “c for 0.5 s”, “a within 1 s after b”. Of a whole log: min " +
                "max first last mean median percentile(x,95) stddev integral count total any all duration time_of_min time_of_max " +
                "slope correlation. Over time: min(x, 1 s) delta derivative previous changed rises falls crosses after before during. " +
                "Modes: enabled, autonomous, teleop."

        private const val MAX_QUANTITIES = 8
        private const val MAX_SPANS = 10
    }
}
