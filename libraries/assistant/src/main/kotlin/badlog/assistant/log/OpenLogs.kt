package badlog.assistant.log

import badlog.assistant.call.Arguments
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.call.ToolException
import badlog.assistant.call.number
import badlog.assistant.call.unitOf
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.recording.Topic
import badlog.files.LogFile
import badlog.files.readLog
import badlog.formats.LOG_FORMATS
import badlog.signals.overItsTime
import badlog.signals.signalTopicsOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject

/** Opens logs of [logs] with all their samples. The last one stays open, since an assistant usually asks about it repeatedly. */
internal class OpenLogs(private val logs: LogFolder) {
    private var last: Pair<LogFile, LogView>? = null

    /** Returns the log named in the argument `log`, with the topics of the argument `formulas`. */
    fun open(arguments: Arguments): OpenLog {
        val (name, file) = logs.log(arguments.requiredText("log"))
        val signals = logs.signals()
        val view = last?.takeIf { it.first == file }?.second ?: read(file).also { last = file to it }
        val formulas = arguments.texts("formulas")
        val with = view.withSignals(signals, file.name).withVirtualTopics(formulas, signals)
        with.errors.firstOrNull()?.let { throw ToolException("This formula cannot be calculated for “$name”: ${it.pointed()}") }
        return OpenLog(name, with.view, signals)
    }

    private fun read(file: LogFile): LogView {
        // Two logs may not fit in memory at the same time.
        last = null
        return LogView.of(readLog(file.path, LOG_FORMATS).orThrow().overItsTime())
    }

    companion object {
        /** The parameter of every tool that opens a log. */
        val LOG: Parameter = Parameter("log", ParameterType.TEXT, "The name of a log, as listed by list_logs.", isRequired = true)

        /** The parameters of tools that use topics. */
        val TOPICS: List<Parameter> = listOf(
            LOG,
            Parameter(
                "topics",
                ParameterType.TEXTS,
                "The names of topics, as listed by describe_log, or of signals such as “battery voltage”.",
                isRequired = true,
            ),
            Parameter(
                "formulas",
                ParameterType.TEXTS,
                "Topics to calculate first, each such as “Power [W] = Battery Voltage * Total Current”.",
            ),
            Parameter("from", ParameterType.NUMBER, "Where the range begins, in the unit of the log's x axis; default: at its start."),
            Parameter("to", ParameterType.NUMBER, "Where the range ends, in the unit of the log's x axis; default: at its end."),
        )
    }
}

/**
 * An open log.
 *
 * @property name its name.
 * @property view its content.
 */
internal class OpenLog(val name: String, val view: LogView, private val signals: SignalVocabulary) {
    /**
     * Returns the lines of the topics named in [arguments], without duplicates.
     *
     * @param most the maximum number of names.
     * @throws ToolException if there is no name, if there are more than [most], or if the log lacks a topic.
     */
    fun lines(arguments: Arguments, most: Int): List<GraphSeries> {
        val names = arguments.texts("topics")
        if (names.size > most) throw ToolException("“topics” has ${names.size} entries; name at most $most at a time.")
        if (names.isEmpty()) throw ToolException("“topics” is empty; name at least one topic.")
        return names.map(::topic).distinct().map(view::seriesOf)
    }

    /** Returns the range requested by [arguments], within the log's; null if the log has no samples. */
    fun range(arguments: Arguments): Span? {
        val whole = view.xAxis.range ?: return null
        val from = arguments.number("from")
        val to = arguments.number("to")
        val unit = if (Units.isNone(view.xAxis.unit)) "" else " ${view.xAxis.unit}"
        if (from != null && to != null && to < from) throw ToolException("“to” ($to$unit) is before “from” ($from$unit); swap them.")
        if ((from != null && from > whole.endInclusive) || (to != null && to < whole.start)) {
            throw ToolException("The log “$name” extends from ${whole.start}$unit to ${whole.endInclusive}$unit; select a range within it.")
        }
        return Span(maxOf(from ?: whole.start, whole.start), minOf(to ?: whole.endInclusive, whole.endInclusive))
    }

    /** Adds a description of x, and the limits of [range], to [answer]. */
    fun putX(answer: JsonObjectBuilder, range: Span?) {
        answer.putJsonObject("x") {
            put("name", view.xAxis.name)
            put("unit", unitOf(view.xAxis.unit))
            if (view.xAxis.isIndex) put("meaning", "row number: the log has no time")
            put("from", number(range?.from))
            put("to", number(range?.to))
        }
    }

    private fun topic(name: String): Topic {
        val topics = view.recording.topics
        return topics.find { it.name == name }
            ?: topics.singleOrNull { it.name.equals(name, ignoreCase = true) }
            ?: signalTopicsOf(view, signals).of(name).firstOrNull()?.let { found -> topics.find { it.name == found.topic } }
            ?: topics.singleOrNull { it.name.endsWith("/$name", ignoreCase = true) }
            ?: throw ToolException("The log “${this.name}” has no topic “${name.take(MAX_SHOWN)}”; describe_log lists its topics.")
    }
}

private const val MAX_SHOWN = 200
