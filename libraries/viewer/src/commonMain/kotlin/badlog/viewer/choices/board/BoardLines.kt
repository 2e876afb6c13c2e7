package badlog.viewer.choices.board

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/**
 * The lines that a board can draw, by name. They are lines of topics, or of graphs that are derived from topics.
 *
 * @property view the log with the lines.
 * @param others graphs of other lines that can be drawn, such as those from a hook.
 */
class BoardLines(val view: LogView, others: List<Graph> = emptyList()) {
    private val topics = view.recording.topics.associateBy { it.name }
    private val derived = (view.folders.flatMap { it.graphs } + others)
        .flatMap { graph -> graph.lineNames.zip(graph.series) }
        .filter { (name, _) -> name !in topics }
        .toMap()
    private val found = HashMap<String, GraphSeries?>()

    /** The names of all lines that can be drawn, the topics first. */
    val names: List<String> get() = topics.values.filter(::isDrawable).map { it.name } + derived.keys

    /** Returns the line called [name]; null if there is none. */
    operator fun get(name: String): GraphSeries? = found.getOrPut(name) { topics[name]?.let(view::seriesOf) ?: derived[name] }
}

/** Returns whether [topic] can be drawn as a line. Events are marks in every graph, and empty topics are not drawn. */
internal fun isDrawable(topic: Topic): Boolean =
    topic.kind != TopicKind.EMPTY && topic.kind != TopicKind.EVENT && "log" !in topic.attributes

/** The board's names for the lines of this graph, in order. */
val Graph.lineNames: List<String> get() = series.map { if (it.isDerived) name else it.topic.name }

/** Returns this graph for a board, which assigns its id. [BoardLines] finds its lines again. */
fun Graph.asBoardGraph(): BoardGraph = BoardGraph(
    id = 0,
    title = if (isVirtual) listOf(folder, title).filter { it.isNotEmpty() }.joinToString("/") else name,
    lines = lineNames.distinct(),
    isFilled = isFilled,
    includesZero = includesZero,
)
