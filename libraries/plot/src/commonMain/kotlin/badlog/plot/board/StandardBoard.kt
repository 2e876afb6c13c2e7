package badlog.plot.board

import badlog.analysis.LogView
import badlog.plot.outline.MANY
import badlog.plot.outline.everChanges
import badlog.plot.outline.outlineOf
import badlog.rules.LogShape
import badlog.rules.signal.SignalTopics
import badlog.rules.signal.SignalVocabulary

/**
 * The graphs that a log begins with: [pathBoard], then [defaultBoard], where that is one that a person can look through, else [boardOfLarge].
 */
public fun standardBoard(view: LogView, vocabulary: SignalVocabulary): Board =
    boardOfLarge(view, vocabulary) ?: pathBoard(view).withGraphs(defaultBoard(view).graphs)

/**
 * The graphs that a log begins with that has more than a person looks through, null for another one: [pathBoard], then those of the signals of
 * [vocabulary] that change: battery and current, modes, loop time, loads, outputs; then those of the others that [outlineOf] draws, of
 * several topics before those of one.
 */
public fun boardOfLarge(view: LogView, vocabulary: SignalVocabulary): Board? {
    if (view.folders.sumOf { it.graphs.size } <= MANY) return null
    // The x axis is not a graph of itself.
    val outlined = outlineOf(view, vocabulary).folders.flatMap { it.folder.graphs }
        .filter { graph -> graph.series.any { it.topic !== view.xAxis.topic } }.map { it to it.asBoardGraph() }
    val together = outlined.filter { (graph, _) -> graph.series.size > 1 && !graph.showsStates }.map { it.second }
    val topics = LogShape.of(view).topicsOf(vocabulary)
    val changing = view.recording.topics.filter(::everChanges).mapTo(HashSet()) { it.name }
    val first = STANDARD.flatMap { signals ->
        val names = signals.flatMap { namesOf(it, topics) }.filter { it in changing }
        // What belongs together stays so: a module's speed beside its target and the other modules'.
        val joint = together.filter { graph -> graph.lines.any { it in names } }
        joint + graphsOf(view, names - joint.flatMap { it.lines }.toSet(), vocabulary)
    }.distinctBy { it.lines }
    val path = pathBoard(view)
    val shown = first.flatMapTo(HashSet()) { it.lines }
    val others = outlined.map { it.second }.filter { graph -> graph.lines.none { it in shown } }
        .sortedByDescending { it.lines.size > 1 }.take(maxOf(0, MOST - first.size - path.graphs.size))
    return path.withGraphs(first + others)
}

private fun namesOf(signal: String, topics: SignalTopics) = topics.of(signal).map { it.topic }

// As high as all others: there is no need to fit one screen.
private fun graphsOf(view: LogView, names: List<String>, vocabulary: SignalVocabulary) =
    evidenceBoard(view, names, vocabulary).graphs.map { it.copy(height = null) }

/** So many graphs a large log begins with at most. */
private const val MOST = 24

private val STANDARD = listOf(
    listOf("battery", "total current"),
    listOf("robot enabled", "robot autonomous", "robot teleop", "brownout", "link"),
    listOf("loop time"),
    listOf("CAN load", "CPU load"),
    listOf("motor output"),
    listOf("motor current"),
    listOf("module speed"),
)
