package badlog.viewer.choices.board

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.recording.PathName
import badlog.expression.signalOf
import badlog.expression.signals.Vocabulary
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
