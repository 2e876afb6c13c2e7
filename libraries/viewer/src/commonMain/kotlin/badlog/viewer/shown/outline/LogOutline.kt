package badlog.viewer.shown.outline

import badlog.core.analysis.Folder
import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.recording.PathName
import badlog.core.recording.Topic
import badlog.signals.LogShape
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.text.exactText
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit

/**
 * The topics of a log that are initially drawn, and the ones that are only listed. Every topic that a graph or a list of events would show
 * is among them.
 *
 * @property folders the drawn and listed content by folder, the root folder first, in the order of the view.
 * @property constants the topics that never change, with their values, in the order of the file.
 * @property empty the topics without any logged value, in the order of the file.
 */
class LogOutline(val folders: List<OutlineFolder>, val constants: List<ConstantTopic> = emptyList(), val empty: List<Topic> = emptyList())

/**
 * A folder of an outline.
 *
 * @property folder the initially drawn part.
 * @property listed the other graphs, which are drawn on request.
 */
class OutlineFolder(val folder: Folder, val listed: List<Graph> = emptyList())

/**
 * A topic that never changes.
 *
 * @property graph the graph that draws it.
 * @property text the value, with its unit.
 * @property exact the value with all digits, with its unit.
 */
class ConstantTopic(val graph: Graph, val text: String, val exact: String) {
    /** The full name of the topic. */
    val name: String get() = graph.name
}

/**
 * Returns the initial outline of [view]. A log with at most [MAX_SHOWN_GRAPHS] graphs shows all graphs that its attributes define. In a
 * larger one, empty and constant topics are not drawn. The parts of an array or struct share a graph, and so do target and actual of one
 * thing, and the states of a folder. The remaining graphs are limited to [MAX_SHOWN_GRAPHS], together with a board's graphs: first graphs
 * of the signals of [vocabulary], then graphs of several topics.
 *
 * @param kept names of graphs that are always drawn unchanged.
 */
fun outlineOf(view: LogView, vocabulary: SignalVocabulary, kept: Set<String> = emptySet()): LogOutline {
    val all = view.folders.flatMap { it.graphs }
    if (all.size <= MAX_SHOWN_GRAPHS) return LogOutline(view.folders.map { OutlineFolder(it) })
    // In the order of the file: in a pose, x is before the angle, but not its folder.
    val places = view.recording.topics.withIndex().associate { (place, topic) -> topic to place }
    val (asked, others) = all.sortedBy { places[it.series[0].topic] ?: 0 }.partition { it.name in kept }
    val (empty, present) = others.partition { graph -> graph.series.all { it.isEmpty } }
    val (changing, still) = groupsOf(present).partition { it.changes }
    val groups = asked.map { TopicGroup(it.name, it.series, it) } + withLanes(changing)
    val first = firstOf(groups, view, vocabulary, kept)
    val (drawn, undrawn) = groups.partition { it in first }
    // A graph that an attribute derives from a constant topic is not a topic, but keeps its place.
    val (derived, constant) = still.partition { group -> group.own != null && group.lines.any { it.isDerived } }
    return LogOutline(
        foldersOf(view, drawn.map { it.toGraph() }, (undrawn + derived).map { it.toGraph() }),
        constant.flatMap { it.lines }.distinctBy { it.topic }.map { line ->
            val sample = line.data.y.indexOfFirst { !it.isNaN() }

            fun text(format: (Double) -> String) = line.textOf(sample) { withUnit(format(it), line.unit) }
            ConstantTopic(
                Graph(line.topic.name, line.unit, isVirtual = false, isFilled = false, includesZero = false, listOf(line)),
                text(::numberText),
                text(::exactText),
            )
        },
        empty.flatMap { it.series }.map { it.topic }.distinct(),
    )
}

/** Returns [groups] with neighboring states of a folder joined, each in a lane. */
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
    return byWorth.take(MAX_FIRST_GRAPHS).toSet()
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

/** The maximum number of graphs that a person looks through. */
const val MAX_SHOWN_GRAPHS: Int = 60

/** The number of folders above which the tree is initially closed. */
const val MAX_OPEN_FOLDERS: Int = 24

/** The maximum number of initial graphs of a large log; a board above them has at most 24. */
private const val MAX_FIRST_GRAPHS = MAX_SHOWN_GRAPHS - 24
private const val OTHER = 3

/**
 * Returns the name of the graph that the part [topic] of an array or struct belongs to. It is the topic's own name if it is not a part:
 *
 * - The elements of an array share one graph: `axes[0]` and `axes[1]` become `axes`. The same applies to the topics of a folder with
 *   numbers as their names.
 * - The fields of a struct share one: x, y and angle of a pose, three speeds of a chassis.
 * - The same field of all swerve modules of a folder shares one: their speeds, their angles, their distances.
 */
internal fun graphNameOf(topic: Topic): String {
    val name = topic.name
    if (STRUCTS.none { topic.type.startsWith(it) }) return arrayOf(name) ?: name
    val fields = fieldsOf(name)
    val owner = name.dropLast(fields.length)
    if ("module" in topic.type.lowercase()) {
        val folder = PathName.folderOf(arrayOf(owner) ?: owner)
        val meaning = MEANINGS.firstOrNull { (field, _) -> fields.startsWith(field) }?.second
        if (meaning != null) return if (folder.isEmpty()) meaning else "$folder/$meaning"
    }
    return owner
}

/** Returns the array with the element [name], or null. */
private fun arrayOf(name: String): String? {
    val bracket = name.lastIndexOf('[')
    if (bracket >= 0 && name.endsWith(']') && isNumber(name.substring(bracket + 1, name.lastIndex))) return name.substring(0, bracket)
    return PathName.folderOf(name).takeIf { it.isNotEmpty() && isNumber(PathName.baseNameOf(name)) }
}

private fun isNumber(text: String) = text.isNotEmpty() && text.all { it in '0'..'9' }

/** Returns the end of [name] that consists of field names, with slashes. It has at least one name if there is a folder. */
private fun fieldsOf(name: String): String {
    var start = name.lastIndexOf('/')
    if (start <= 0) return ""
    while (start > 0) {
        val before = name.lastIndexOf('/', start - 1)
        // An array's brackets belong to the owner of the field, not to the field.
        if (before <= 0 || name.substring(before + 1, start) !in NESTED) break
        start = before
    }
    return name.substring(start)
}

/** Returns whether [topic] has two different values. */
fun everChanges(topic: Topic): Boolean {
    val first = topic.samples.firstOrNull { !it.isNaN() }
    return topic.texts.dictionary.size > 1 || (first != null && topic.samples.any { !it.isNaN() && it != first })
}

/** Whether the line has nothing to draw. */
internal val GraphSeries.isEmpty: Boolean get() = topic.texts.size == 0 && topic.samples.all { it.isNaN() }

/** The structs of a log, and WPILib's equivalent messages. */
private val STRUCTS = listOf("struct:", "proto:wpi.proto.")

/** Fields of WPILib's structs that have fields themselves. */
private val NESTED = setOf("translation", "rotation", "q", "angle")

private val MEANINGS = listOf(
    "/speed" to "Module speeds",
    "/velocity" to "Module speeds",
    "/angle" to "Module angles",
    "/distance" to "Module distances",
)
