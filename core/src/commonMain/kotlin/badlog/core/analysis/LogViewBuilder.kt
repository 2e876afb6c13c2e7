package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.core.recording.Value
import badlog.core.recording.timesText
import badlog.core.text.freeName
import kotlin.math.abs

/** Makes a [LogView]: applies the attributes, finds the x axis, then lays out graphs and event logs by folder. */
internal class LogViewBuilder(private val recording: Recording, private val registry: AttributeRegistry) {
    private val problems = ArrayList<Problem>()
    private val graphs = ArrayList<GraphDraft>()
    private val graphOfName = HashMap<String, GraphDraft>()
    private val eventLogs = ArrayList<EventLog>()
    private val topicNames = recording.topics.mapTo(HashSet()) { it.name }

    private class GraphDraft(
        val name: String,
        val unit: String,
        val isVirtual: Boolean,
        val isFilled: Boolean = false,
        val includesZero: Boolean = false,
        val series: MutableList<GraphSeries> = ArrayList(),
    ) {
        fun toGraph() = Graph(name, unit, isVirtual, isFilled, includesZero, series)
    }

    fun build(): LogView {
        val plans = recording.topics.map(::planOf)
        val xAxis = findXAxis(plans)
        for (plan in plans) addTopic(plan, xAxis)
        // Last, so that all topics' graphs have their names before anything joins them.
        for (plan in plans) for (graph in plan.joins) join(plan, graph, xAxis)
        return LogView(
            recording = recording,
            title = matchTitle(recording.values),
            xAxis = xAxis,
            folders = folders(recording.values, eventLogs, graphs.map { it.toGraph() }),
            problems = recording.problems + problems,
        )
    }

    private fun planOf(topic: Topic): TopicPlan {
        val plan = TopicPlan(topic) { problems += it }
        val seen = HashSet<String>()
        for (text in topic.attributes) {
            if (text.isBlank()) continue
            if (!seen.add(text)) {
                plan.report(ProblemKind.DUPLICATE_ATTRIBUTE, "“${topic.name}” has the attribute “$text” twice.")
                continue
            }
            val attribute = registry.find(text)
            if (attribute == null) {
                plan.report(
                    ProblemKind.UNKNOWN_ATTRIBUTE,
                    "“${topic.name}” has the attribute “$text”, which is unknown and has no effect.",
                )
            } else {
                attribute.apply(plan, text.substringAfter(':', "").takeIf { ':' in text })
            }
        }
        if ("log" in seen && seen.size > 1) {
            plan.report(
                ProblemKind.UNFIT_ATTRIBUTE,
                "“${topic.name}” is an event log; its other attributes (${(seen - "log").joinToString()}) have no effect.",
            )
        }
        return plan
    }

    private fun findXAxis(plans: List<TopicPlan>): XAxis {
        val wanted = plans.filter { it.isX }
        for (second in wanted.drop(1)) {
            second.report(
                ProblemKind.SECOND_X_AXIS,
                "“${second.topic.name}” has the attribute xaxis, but “${wanted[0].topic.name}” already is the x axis.",
            )
        }
        XAxis.ofOwnTimes(recording)?.let { time ->
            wanted.firstOrNull()?.report(
                ProblemKind.UNFIT_ATTRIBUTE,
                "“${wanted[0].topic.name}” cannot be the x axis: the topics of this log have their own times.",
            )
            return time
        }
        val plan = wanted.firstOrNull() ?: return XAxis.index(recording)
        if (plan.isNumeric || recording.rowCount == 0) return XAxis.of(plan.topic, recording).also { reportX(plan, it) }
        plan.report(
            ProblemKind.UNFIT_ATTRIBUTE,
            "“${plan.topic.name}” has no numbers and cannot be the x axis; the row index is used instead.",
        )
        return XAxis.index(recording)
    }

    private fun reportX(plan: TopicPlan, xAxis: XAxis) {
        val x = plan.topic.samples
        val name = plan.topic.name
        var backwards = 0
        var repeats = 0
        var gaps = 0
        var last = Double.NaN
        for (position in x) {
            if (!position.isFinite()) {
                gaps++
                continue
            }
            if (position < last) {
                backwards++
            } else if (position == last) {
                repeats++
            }
            last = position
        }
        if (xAxis.wildCount > 0) {
            plan.report(
                ProblemKind.X_WILD,
                "The x axis “$name” is far off in ${xAxis.wildCount} of ${x.size} rows, such as at " +
                    "${textOf(xAxis.wildest)}; these rows are not drawn. Check the robot's clock.",
            )
        }
        if (backwards > 0) {
            plan.report(
                ProblemKind.X_BACKWARDS,
                "The x axis “$name” goes backwards${timesText(backwards)}, as when the robot's clock is set; " +
                    "derivatives have a gap there.",
            )
        }
        if (repeats > 0) {
            plan.report(
                ProblemKind.X_REPEATS,
                "The x axis “$name” repeats a value${timesText(repeats)}; derivatives have a gap there.",
            )
        }
        if (gaps > 0) {
            plan.report(ProblemKind.X_GAPS, "The x axis “$name” has no value in $gaps of ${x.size} rows; these rows are not drawn.")
        }
    }

    private fun addTopic(plan: TopicPlan, xAxis: XAxis) {
        val topic = plan.topic
        if (plan.isEventLog) {
            if (!plan.isHidden) eventLogs += EventLog(topic, xAxis)
            return
        }
        if (!plan.isHidden) {
            addGraph(GraphDraft(topic.name, topic.unit, false, plan.isFilled, plan.includesZero))
                .series += seriesOf(topic, xAxis)
        }
        for (derivation in plan.derivations) {
            if (!plan.isNumeric && topic.kind != TopicKind.EMPTY) {
                plan.report(
                    ProblemKind.UNFIT_ATTRIBUTE,
                    "“${derivation.name}” cannot be calculated, because “${topic.name}” holds texts.",
                )
                continue
            }
            val unit = derivation.unit(topic.unit, xAxis.unit)
            // A topic, or another derived graph, may already have the name that this one would get; both are shown.
            val name = freeName(derivation.name) { it !in topicNames && it !in graphOfName }
            addGraph(GraphDraft(name, unit, isVirtual = true)).series +=
                GraphSeries(PathName.baseNameOf(name), unit, topic, null, isDerived = true, range = xAxis::range) {
                    derivation.series(samplesOf(topic, xAxis))
                }
        }
    }

    private fun addGraph(draft: GraphDraft): GraphDraft {
        graphs += draft
        graphOfName[draft.name] = draft
        return draft
    }

    private fun join(plan: TopicPlan, name: String, xAxis: XAxis) {
        val topic = plan.topic
        if (plan.isEventLog || topic.kind == TopicKind.STATE) {
            plan.report(ProblemKind.UNFIT_ATTRIBUTE, "“${topic.name}” holds texts and cannot join the graph “$name”.")
            return
        }
        if (name in topicNames) {
            plan.report(ProblemKind.UNUSUAL_JOIN, "“${topic.name}” joins “$name”, which is the graph of a topic.")
        }
        val graph = graphOfName[name] ?: addGraph(GraphDraft(name, topic.unit, isVirtual = true))
        val series = GraphSeries(PathName.baseNameOf(topic.name), topic.unit, topic, null, range = xAxis::range) { samplesOf(topic, xAxis) }
        if (graph.unit != topic.unit) {
            plan.report(
                ProblemKind.UNUSUAL_JOIN,
                "“${topic.name}” in ${topic.unit} joins the graph “$name” in ${graph.unit}.",
            )
        }
        if (graph.series.any { it.name == series.name }) {
            plan.report(ProblemKind.UNUSUAL_JOIN, "The graph “$name” has several lines named “${series.name}”.")
        }
        graph.series += series
    }
}

/** Returns [number] without a fraction, with the same text on every platform where that is possible. */
private fun textOf(number: Double): String = if (abs(number) < WHOLE) number.toLong().toString() else number.toString()

private const val WHOLE = 1e15

/** Sorts everything into folders: the root folder first, then the others regardless of case. */
private fun folders(values: List<Value>, eventLogs: List<EventLog>, graphs: List<Graph>): List<Folder> {
    val valuesOf = values.groupBy { PathName.folderOf(it.name) }
    val eventLogsOf = eventLogs.groupBy { PathName.folderOf(it.name) }
    val graphsOf = graphs.groupBy { it.folder }
    val names = (valuesOf.keys + eventLogsOf.keys + graphsOf.keys).sortedWith(compareBy({ it.lowercase() }, { it }))
    return names.map { name ->
        Folder(name, valuesOf[name].orEmpty(), eventLogsOf[name].orEmpty(), graphsOf[name].orEmpty())
    }
}
