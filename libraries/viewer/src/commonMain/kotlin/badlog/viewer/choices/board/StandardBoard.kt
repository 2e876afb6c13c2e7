package badlog.viewer.choices.board

import badlog.core.analysis.Graph
import badlog.core.analysis.LogView
import badlog.signals.LogShape
import badlog.signals.pose.Pose
import badlog.signals.pose.PoseRole
import badlog.signals.pose.posesOf
import badlog.signals.vocabulary.SignalTopics
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.shown.outline.MAX_SHOWN_GRAPHS
import badlog.viewer.shown.outline.everChanges
import badlog.viewer.shown.outline.outlineOf
import badlog.viewer.shown.search.Query

/**
 * Returns the initial graphs of a log for a board that holds all of them: [boardAbove], then the rest of [defaultBoard]. A log with more
 * graphs than a person looks through has only [boardAbove].
 *
 * @param pointed the evidence of the first finding; used only if not all graphs are on the board anyway.
 */
fun standardBoard(view: LogView, vocabulary: SignalVocabulary, pointed: List<String> = emptyList()): Board {
    boardOfLarge(view, vocabulary, pointed)?.let { return it }
    val above = boardAbove(view, vocabulary)
    // A path is drawn on a field, so its parts are not yet drawn over time.
    val shown = above.graphs.filterNot { it.isXy }.flatMapTo(HashSet()) { it.lines }
    return above.withGraphs(defaultBoard(view).graphs.filterNot { shown.containsAll(it.lines) }).identifiedByLines()
}

/**
 * Returns the graphs that are initially above all other graphs of a log. A log with more graphs than a person looks through has at most 24:
 * graphs of its signals, of the topics [pointed], and of several topics together. Any other log has [pathBoard] and, if its graphs would be
 * far apart, small graphs of the topics that explain most of a match, if they change: battery and current together, modes, loop time, and
 * the topics [pointed].
 *
 * @param pointed the evidence of the first finding.
 */
fun boardAbove(view: LogView, vocabulary: SignalVocabulary, pointed: List<String> = emptyList()): Board {
    boardOfLarge(view, vocabulary, pointed)?.let { return it }
    val path = pathBoard(view)
    if (view.folders.sumOf { it.graphs.size } <= MAX_CLOSE_GRAPHS) return path.identifiedByLines()
    val topics = LogShape.of(view).topicsOf(vocabulary)
    val changing = changingIn(view)
    val power = POWER.mapNotNull { signal -> namesOf(signal, topics).firstOrNull { it in changing } }
    val together = BoardGraph(0, "Battery and current", power, height = GraphHeight.SMALL.pixels)
    val first = if (power.size == POWER.size) listOf(together) else evidenceBoard(view, power, vocabulary).graphs
    val others = listOf(MODES, LOOP).flatMap { signals ->
        evidenceBoard(view, signals.flatMap { namesOf(it, topics) }.filter { it in changing }, vocabulary).graphs
    }
    val all = path.withGraphs(first + others)
    return all.withGraphs(evidenceBeside(all.graphs, view, pointed, vocabulary)).identifiedByLines()
}

private fun evidenceBeside(graphs: List<BoardGraph>, view: LogView, pointed: List<String>, vocabulary: SignalVocabulary): List<BoardGraph> {
    val shown = graphs.flatMapTo(HashSet()) { it.lines }
    return evidenceBoard(view, pointed.filter { it !in shown }, vocabulary).graphs.take(MAX_POINTED)
}

private fun changingIn(view: LogView) = view.recording.topics.filter(::everChanges).mapTo(HashSet()) { it.name }

/**
 * Returns the initial graphs of a log with more of them than a person looks through. Null for a smaller log. [pathBoard] is first, then
 * graphs of changing signals of [vocabulary]: battery and current, modes, loop time, loads, outputs, and the topics [pointed]. The other
 * graphs that [outlineOf] draws follow, the ones of several topics first.
 */
private fun boardOfLarge(view: LogView, vocabulary: SignalVocabulary, pointed: List<String> = emptyList()): Board? {
    if (view.folders.sumOf { it.graphs.size } <= MAX_SHOWN_GRAPHS) return null
    // The x axis does not have a graph.
    val outlined = outlineOf(view, vocabulary).folders.flatMap { it.folder.graphs }
        .filter { graph -> graph.series.any { it.topic !== view.xAxis.topic } }.map { it to it.asBoardGraph() }
    val together = outlined.filter { (graph, _) -> graph.series.size > 1 && !graph.showsStates }.map { it.second }
    val topics = LogShape.of(view).topicsOf(vocabulary)
    val changing = changingIn(view)
    val signals = STANDARD.flatMap { signals ->
        val names = signals.flatMap { namesOf(it, topics) }.filter { it in changing }
        // Related topics stay together: a module's speed beside its target and the speeds of the other modules.
        val joint = together.filter { graph -> graph.lines.any { it in names } }
        joint + graphsOf(view, names - joint.flatMap { it.lines }.toSet(), vocabulary)
    }.distinctBy { it.lines }
    val path = pathBoard(view)
    val first = signals + evidenceBeside(path.graphs + signals, view, pointed, vocabulary).map { it.copy(height = null) }
    val shown = first.flatMapTo(HashSet()) { it.lines }
    val others = outlined.map { it.second }.filter { graph -> graph.lines.none { it in shown } }
        .sortedByDescending { it.lines.size > 1 }.take(maxOf(0, MAX_GRAPHS - first.size - path.graphs.size))
    return path.withGraphs(first + others).identifiedByLines()
}

private fun namesOf(signal: String, topics: SignalTopics) = topics.of(signal).map { it.topic }

// The default height is possible, because these graphs need not fit on one screen.
private fun graphsOf(view: LogView, names: List<String>, vocabulary: SignalVocabulary) =
    evidenceBoard(view, names, vocabulary).graphs.map { it.copy(height = null) }

/** The maximum number of initial graphs of a large log. */
private const val MAX_GRAPHS = 24

/** The maximum number of graphs that are close enough together. */
private const val MAX_CLOSE_GRAPHS = 10

/** The maximum number of graphs from a finding beside the others. */
private const val MAX_POINTED = 2

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

/** Returns the paths of [view] in one graph: driven, planned and seen ones, a few of each. Without a driven path, the board is empty. */
fun pathBoard(view: LogView): Board {
    val changing = view.recording.topics.filter(::everChanges).mapTo(HashSet()) { it.name }
    val poses = posesOf(view.recording.topics).filter { it.x in changing || it.y in changing }
    fun of(role: PoseRole, most: Int) = poses.filter { it.role == role }.distinctBy { it.list ?: it.name }.sortedBy { it.depth }.take(most)
    val driven = of(PoseRole.DRIVEN, MAX_DRIVEN)
    if (driven.isEmpty()) return Board()
    val shown = driven + of(PoseRole.PLANNED, MAX_PLANNED) + of(PoseRole.SEEN, MAX_SEEN)
    return Board().withGraphs(
        listOf(BoardGraph(0, "Path", shown.flatMap { listOf(it.x, it.y) }.distinct(), isXy = true)),
    )
}

/**
 * Returns the graphs of paths that a search for [query] offers beside the topics; none without a query. There is one for each of [poses],
 * or for all elements of an array of poses; it is found by its name and by the word “path”.
 */
fun pathGraphs(poses: List<Pose>, query: Query): List<BoardGraph> {
    if (query.isEmpty) return emptyList()
    return poses.groupBy { it.list ?: it.name }
        .map { (name, places) -> BoardGraph(0, "Path of $name", places.flatMap { listOf(it.x, it.y) }.distinct(), isXy = true) }
        .filter { query.matches(it.title) }.take(MAX_OFFERED)
}

private const val MAX_OFFERED = 20
private const val MAX_DRIVEN = 2
private const val MAX_PLANNED = 2
private const val MAX_SEEN = 3

/**
 * Returns the graphs that the attributes of a recording's topics define, in order. Neighboring states of a folder share a graph with a
 * lane for each, as many as fit on a screen. The x axis does not have a graph. Topics with their own times, as in a WPILOG with
 * everything from a dashboard, are omitted if they never change, unless nothing changes.
 */
fun defaultBoard(view: LogView): Board {
    val hasChanges = view.folders.any { folder -> folder.graphs.any(::changes) }
    val specs = view.folders.flatMap { folder ->
        val graphsOfFolder = folder.graphs.filter { graph ->
            graph.series.any { it.isDerived || it.topic !== view.xAxis.topic } && (!hasChanges || changes(graph))
        }
        framesOf(graphsOfFolder).map { graphs ->
            val first = graphs.first().asBoardGraph()
            if (graphs.size == 1) return@map first
            first.copy(title = statesTitle(folder.name), lines = graphs.flatMap { it.asBoardGraph().lines }.distinct())
        }
    }
    return Board(specs).identifiedByLines()
}

private fun changes(graph: Graph) = graph.series.any { it.topic.times == null || everChanges(it.topic) }

/**
 * Returns the [graphs] of a folder grouped by frame. Neighbors with states share a frame, with a lane for each, as many as fit on a screen.
 * Each other graph has its own frame.
 *
 * @param isAlone whether a graph has its own frame although it shows states.
 */
fun framesOf(graphs: List<Graph>, isAlone: (Graph) -> Boolean = { false }): List<List<Graph>> {
    val frames = ArrayList<MutableList<Graph>>()
    for (graph in graphs) {
        val last = frames.lastOrNull()
        val isJoined = graph.showsStates && !isAlone(graph) && last != null && last.first().showsStates && !isAlone(last.first())
        if (isJoined && last.sumOf { it.series.size } + graph.series.size <= MAX_LANES) last += graph else frames += mutableListOf(graph)
    }
    return frames
}

/** Returns the title of a frame with the states of several graphs of [folder], including the folder. */
fun statesTitle(folder: String): String = if (folder.isEmpty()) "States" else "$folder/States"

/** Returns one graph with all lanes of [frame], which is one of the frames that [framesOf] returns. */
fun laneGraphOf(frame: List<Graph>): Graph {
    val first = frame.first()
    if (frame.size == 1) return first
    return Graph(statesTitle(first.folder), first.unit, isVirtual = false, first.isFilled, first.includesZero, frame.flatMap { it.series })
}

private const val MAX_LANES = 16
