package badlog.plot.outline

import badlog.analysis.Folder
import badlog.analysis.Graph
import badlog.analysis.LogView
import badlog.plot.cursor.textOf
import badlog.plot.text.exactText
import badlog.plot.text.withUnit
import badlog.recording.Topic
import badlog.rules.LogShape
import badlog.rules.signal.SignalVocabulary

/**
 * What of a log is drawn at first, and what is only listed: every topic that a graph or a list of events would show is in one of these.
 *
 * @property folders what is drawn and listed by folder, the root folder first, as a view has them.
 * @property constants what never changes, with its value, in the order of the file.
 * @property empty the topics of which nothing was logged, in the order of the file.
 */
public class LogOutline(
    public val folders: List<OutlineFolder>,
    public val constants: List<ConstantTopic> = emptyList(),
    public val empty: List<Topic> = emptyList(),
)

/**
 * A folder of an outline.
 *
 * @property folder what is shown of it at first.
 * @property listed its other graphs, which are drawn when somebody asks for them.
 */
public class OutlineFolder(public val folder: Folder, public val listed: List<Graph> = emptyList())

/**
 * A topic that never changes.
 *
 * @property graph draws it.
 * @property text its value, with its unit.
 */
public class ConstantTopic(public val graph: Graph, public val text: String) {
    /** The full name of the topic. */
    public val name: String get() = graph.name
}

/**
 * What [view] begins with. A log of at most [MANY] graphs shows all that its attributes ask for. Of a larger one, what was never logged
 * and what never changes is not drawn, the parts of an array or struct share a graph, as do target and actual of one thing and the
 * states of a folder; and of what is left then so many are drawn that there are no more than [MANY] with those of a board: first those of
 * the signals of [vocabulary], then those that show several topics.
 *
 * @param kept names of graphs that are drawn in any case, as they are.
 */
public fun outlineOf(view: LogView, vocabulary: SignalVocabulary, kept: Set<String> = emptySet()): LogOutline {
    val all = view.folders.flatMap { it.graphs }
    if (all.size <= MANY) return LogOutline(view.folders.map { OutlineFolder(it) })
    // In the order of the file: of a pose x comes before the angle, though its folder does not.
    val places = view.recording.topics.withIndex().associate { (place, topic) -> topic to place }
    val (asked, others) = all.sortedBy { places[it.series[0].topic] ?: 0 }.partition { it.name in kept }
    val (empty, present) = others.partition { graph -> graph.series.all { it.isEmpty } }
    val (changing, still) = groupsOf(present).partition { it.changes }
    val groups = asked.map { TopicGroup(it.name, it.series, it) } + withLanes(changing)
    val first = firstOf(groups, view, vocabulary, kept)
    val (drawn, undrawn) = groups.partition { it in first }
    // What attributes derive from a topic that never changes is no topic, but has its place.
    val (derived, constant) = still.partition { group -> group.own != null && group.lines.any { it.isDerived } }
    return LogOutline(
        foldersOf(view, drawn.map { it.toGraph() }, (undrawn + derived).map { it.toGraph() }),
        constant.flatMap { it.lines }.distinctBy { it.topic }.map { line ->
            val sample = line.data.y.indexOfFirst { !it.isNaN() }
            ConstantTopic(
                Graph(line.topic.name, line.unit, isVirtual = false, isFilled = false, includesZero = false, listOf(line)),
                line.textOf(sample) { withUnit(exactText(it), line.unit) },
            )
        },
        empty.flatMap { it.series }.map { it.topic }.distinct(),
    )
}

/** [groups] with the states of a folder together that follow one another, each in a lane. */
private fun withLanes(groups: List<TopicGroup>): List<TopicGroup> {
    val alone = groups.filter { it.showsStates && it.own == null && !it.isTogether }
    val blocks = alone.groupBy { it.folder }.values.flatMap(::inParts).filter { it.size > 1 }
    val blockOf = blocks.flatMap { block -> block.map { it to block } }.toMap()
    return groups.mapNotNull { group ->
        val block = blockOf[group] ?: return@mapNotNull group
        if (group !== block[0]) return@mapNotNull null
        val name = listOf(group.folder, "States").filter { it.isNotEmpty() }.joinToString("/")
        TopicGroup(name, block.flatMap { it.lines }, isTogether = true)
    }
}

private fun firstOf(groups: List<TopicGroup>, view: LogView, vocabulary: SignalVocabulary, kept: Set<String>): Set<TopicGroup> {
    val signals = LogShape.of(view).topicsOf(vocabulary).all.mapTo(HashSet()) { it.topic }
    val byWorth = groups.sortedBy { group ->
        when {
            group.name in kept -> 0
            group.lines.any { it.topic.name in signals } -> 1
            group.isTogether || group.own != null -> 2
            else -> OTHER
        }
    }
    return byWorth.take(MOST).toSet()
}

private fun foldersOf(view: LogView, drawn: List<Graph>, listed: List<Graph>): List<OutlineFolder> {
    val drawnOf = drawn.groupBy { it.folder }
    val listedOf = listed.groupBy { it.folder }
    val others = view.folders.associateBy { it.name }
    val names = (others.keys + drawnOf.keys + listedOf.keys).sortedWith(compareBy({ it.lowercase() }, { it }))
    return names.mapNotNull { name ->
        val values = others[name]?.values.orEmpty()
        val events = others[name]?.eventLogs.orEmpty()
        val folder = Folder(name, values, events, drawnOf[name].orEmpty())
        val rest = listedOf[name].orEmpty()
        if (values.isEmpty() && events.isEmpty() && folder.graphs.isEmpty() && rest.isEmpty()) null else OutlineFolder(folder, rest)
    }
}

/** So many graphs are no more than a person looks through. */
public const val MANY: Int = 60

/** More folders than these are a tree that begins closed. */
public const val MANY_FOLDERS: Int = 24

/** So many graphs a large log begins with: a board above them has 24 at most. */
private const val MOST = MANY - 24
private const val OTHER = 3
