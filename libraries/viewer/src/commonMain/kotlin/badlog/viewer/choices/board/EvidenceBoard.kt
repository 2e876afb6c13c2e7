package badlog.viewer.choices.board

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.recording.PathName
import badlog.core.text.UniqueNames
import badlog.expression.signalOf
import badlog.expression.signals.Vocabulary
import badlog.signals.LogShape
import badlog.signals.pose.posesOf
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.text.shortNames

/**
 * Returns the graphs that show the topics called [evidence] together, low enough for one screen. Poses are paths on a field, other
 * numbers with the same unit share a graph, and the states share one. Unknown names, topics without samples, and events, which are marks
 * in every graph, are omitted.
 *
 * @param vocabulary provides units for topics without one: volts and amperes in one graph would hide each other.
 */
fun evidenceBoard(view: LogView, evidence: List<String>, vocabulary: SignalVocabulary): Board {
    val topics = view.recording.topics.associateBy { it.name }
    val poses = posesOf(view.recording.topics).filter { it.x in evidence && it.y in evidence }
    val places = poses.flatMap { listOf(it.x, it.y) }
    val paths = if (places.isEmpty()) emptyList() else listOf(BoardGraph(1, "Path", places, isXy = true))
    val lines = (evidence.distinct() - places.toSet()).mapNotNull(topics::get)
        .filter(::isDrawable).map(view::seriesOf)
    val names = Vocabulary(lines.map { signalOf(it.topic) })
    val meant = SignalTopics(vocabulary, names, timeTopic = null).all.associate { it.topic to it.unit }
    fun unitOf(line: GraphSeries) = if (Units.isNone(line.unit)) meant[line.topic.name].orEmpty() else line.unit
    val (states, numbers) = lines.partition { it.states != null }
    val groups = numbers.groupBy(::unitOf).values.map { it.take(MAX_LINES) }
    val lanes = listOf(states.take(MAX_LANES)).filter { it.isNotEmpty() }
    val shown = groups.take(MAX_GRAPHS - lanes.size - paths.size) + lanes
    return Board(
        paths + shown.mapIndexed { i, group ->
            BoardGraph(paths.size + i + 1, titleOf(group), group.map { it.topic.name }, height = GraphHeight.SMALL.pixels)
        },
    )
}

/** Returns the name of a single line, the common folder of several, or the names of the first ones. */
private fun titleOf(lines: List<GraphSeries>): String {
    val names = lines.map { it.topic.name }
    if (names.size == 1) return names[0]
    val folder = names.map(PathName::folderOf).distinct().singleOrNull().orEmpty()
    val listed = (if (folder.isEmpty()) shortNames(names) else names.map { it.removePrefix("$folder/") }).take(MAX_NAMES).joinToString()
    val title = if (names.size > MAX_NAMES) "$listed…" else listed
    return if (folder.isEmpty()) title else "$folder: $title"
}

private const val MAX_GRAPHS = 4
private const val MAX_LINES = 4
private const val MAX_LANES = 6
private const val MAX_NAMES = 2

/** The titles of the graphs in order, made unique. Repeated titles end with a number, as in `Speed (2)`. */
val Board.titles: List<String> get() = numbered(graphs.map { it.title })

/**
 * The titles with only as much of each path as distinguishes it from the others: `Left/Speed` and `Right/Speed`. A title that lists
 * several lines stays whole, because its last slash belongs to the last line only.
 */
val Board.shortTitles: List<String>
    get() {
        val (paths, lists) = graphs.partition { it.isTitledByPath }
        val short = paths.map { it.id }.zip(shortNames(paths.map { it.title })).toMap() + lists.associate { it.id to it.title }
        return numbered(graphs.map { short.getValue(it.id) })
    }

/** Returns the title of [graph] among the [titles], or its own title if it is not on the board. */
fun Board.titleOf(graph: BoardGraph): String = titles.getOrElse(graphs.indexOfFirst { it.id == graph.id }) { graph.title }

/** Whether the title is the path of a topic or a joined graph. Otherwise it is a list of lines from [evidenceBoard]. */
val BoardGraph.isTitledByPath: Boolean get() = title in lines || LIST_SEPARATOR !in title

private fun numbered(titles: List<String>): List<String> = UniqueNames().run { titles.map(::give) }

private const val LIST_SEPARATOR = ", "

/**
 * Graphs that may help to investigate a finding, in addition to its evidence.
 *
 * @property label the content of the graphs, as in “+ Current”.
 * @property topics the full names of the topics.
 */
class EvidenceOffer(val label: String, val topics: List<String>)

/** Returns offers for the well-known signals of [vocabulary] in [view] that [board] does not show yet. */
fun evidenceOffers(view: LogView, vocabulary: SignalVocabulary, board: Board): List<EvidenceOffer> {
    val topics = LogShape.of(view).topicsOf(vocabulary).all
    val shown = board.placesOfLines().keys
    return OFFERED.mapNotNull { (label, signals) ->
        val names = signals.flatMap { signal -> topics.filter { it.signal == signal } }.map { it.topic }.distinct()
        if (names.isEmpty() || names.any { it in shown }) null else EvidenceOffer(label, names)
    }
}

/** Returns this board with graphs of [offer] below its own; [vocabulary] provides units for topics without one. */
fun Board.with(offer: EvidenceOffer, view: LogView, vocabulary: SignalVocabulary): Board =
    withGraphs(evidenceBoard(view, offer.topics, vocabulary).graphs)

private val OFFERED = listOf(
    "Voltage" to listOf("battery"),
    "Current" to listOf("total current", "channel current"),
    "Outputs" to listOf("motor output", "motor voltage"),
    "Modes" to listOf("robot enabled", "robot autonomous", "robot teleop"),
    "Loop time" to listOf("loop time"),
)
