package badlog.plot.board

import badlog.analysis.LogView
import badlog.plot.outline.MANY
import badlog.plot.outline.everChanges
import badlog.plot.outline.outlineOf
import badlog.rules.LogShape
import badlog.rules.signal.SignalTopics
import badlog.rules.signal.SignalVocabulary

/**
 * The graphs that a log begins with where all of them stand on the board: [boardAbove], then what else [defaultBoard] has. Of a log with more
 * than a person looks through, [boardAbove] alone.
 *
 * @param pointed the topics that the first of all findings points at; they count where not all graphs stand here anyway.
 */
public fun standardBoard(view: LogView, vocabulary: SignalVocabulary, pointed: List<String> = emptyList()): Board {
    boardOfLarge(view, vocabulary, pointed)?.let { return it }
    val above = boardAbove(view, vocabulary)
    // A path is drawn over a field: what it is made of is not yet drawn over time.
    val shown = above.graphs.filterNot { it.isXy }.flatMapTo(HashSet()) { it.lines }
    return above.withGraphs(defaultBoard(view).graphs.filterNot { shown.containsAll(it.lines) })
}

/**
 * The graphs that begin above all graphs of a log: of one with more than a person looks through, those of its signals, of what [pointed] names,
 * and of several topics, 24 at most. Else [pathBoard], and where the others would stand far apart, low ones of what explains most of a match, as
 * far as it changes: battery and current together, modes, loop time, and what [pointed] names.
 *
 * @param pointed the topics that the first of all findings points at.
 */
public fun boardAbove(view: LogView, vocabulary: SignalVocabulary, pointed: List<String> = emptyList()): Board {
    boardOfLarge(view, vocabulary, pointed)?.let { return it }
    val path = pathBoard(view)
    if (view.folders.sumOf { it.graphs.size } <= FEW) return path
    val topics = LogShape.of(view).topicsOf(vocabulary)
    val changing = changingIn(view)
    val power = POWER.mapNotNull { signal -> namesOf(signal, topics).firstOrNull { it in changing } }
    val together = BoardGraph(0, "Battery and current", power, height = GraphHeight.SMALL.pixels)
    val first = if (power.size == POWER.size) listOf(together) else evidenceBoard(view, power, vocabulary).graphs
    val others = listOf(MODES, LOOP).flatMap { signals ->
        evidenceBoard(view, signals.flatMap { namesOf(it, topics) }.filter { it in changing }, vocabulary).graphs
    }
    return path.withGraphs(first + others).let { it.withGraphs(evidenceBeside(it.graphs, view, pointed, vocabulary)) }
}

private fun evidenceBeside(graphs: List<BoardGraph>, view: LogView, pointed: List<String>, vocabulary: SignalVocabulary): List<BoardGraph> {
    val shown = graphs.flatMapTo(HashSet()) { it.lines }
    return evidenceBoard(view, pointed.filter { it !in shown }, vocabulary).graphs.take(MOST_POINTED)
}

private fun changingIn(view: LogView) = view.recording.topics.filter(::everChanges).mapTo(HashSet()) { it.name }

/**
 * The graphs that a log begins with that has more than a person looks through, null for another one: [pathBoard], then those of the signals of
 * [vocabulary] that change: battery and current, modes, loop time, loads, outputs, and what [pointed] names; then those of the others that
 * [outlineOf] draws, of several topics before those of one.
 */
private fun boardOfLarge(view: LogView, vocabulary: SignalVocabulary, pointed: List<String> = emptyList()): Board? {
    if (view.folders.sumOf { it.graphs.size } <= MANY) return null
    // The x axis is not a graph of itself.
    val outlined = outlineOf(view, vocabulary).folders.flatMap { it.folder.graphs }
        .filter { graph -> graph.series.any { it.topic !== view.xAxis.topic } }.map { it to it.asBoardGraph() }
    val together = outlined.filter { (graph, _) -> graph.series.size > 1 && !graph.showsStates }.map { it.second }
    val topics = LogShape.of(view).topicsOf(vocabulary)
    val changing = changingIn(view)
    val signals = STANDARD.flatMap { signals ->
        val names = signals.flatMap { namesOf(it, topics) }.filter { it in changing }
        // What belongs together stays so: a module's speed beside its target and the other modules'.
        val joint = together.filter { graph -> graph.lines.any { it in names } }
        joint + graphsOf(view, names - joint.flatMap { it.lines }.toSet(), vocabulary)
    }.distinctBy { it.lines }
    val path = pathBoard(view)
    val first = signals + evidenceBeside(path.graphs + signals, view, pointed, vocabulary).map { it.copy(height = null) }
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

/** So many graphs stand near enough to each other. */
private const val FEW = 10

/** So many graphs of a finding stand beside the others. */
private const val MOST_POINTED = 2

private val POWER = listOf("battery", "total current")
private val MODES = listOf("robot enabled", "robot autonomous", "robot teleop", "brownout", "link")
private val LOOP = listOf("loop time")

private val STANDARD = listOf(
    POWER,
    MODES,
    LOOP,
    listOf("CAN load", "CPU load"),
    listOf("motor output"),
    listOf("motor current"),
    listOf("module speed"),
)
