package badlog.viewer.shown.outline

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Units
import badlog.core.recording.PathName

/**
 * Lines that belong in one graph.
 *
 * @property name the full name.
 * @property own the graph that attributes define, which stays unchanged; null for one that is put together here.
 * @property isTogether whether it shows more than one topic.
 */
internal class TopicGroup(val name: String, val lines: List<GraphSeries>, val own: Graph? = null, val isTogether: Boolean = false) {
    val showsStates: Boolean get() = lines.all { it.states != null }

    /** Whether any of the lines has two different values. */
    val changes: Boolean by lazy { lines.any { everChanges(it.topic) } }

    val folder: String get() = PathName.folderOf(name)

    fun toGraph(): Graph = own ?: Graph(name, lines[0].unit, isVirtual = false, isFilled = false, includesZero = false, lines)
}

/** Returns [graphs] with the parts of arrays and structs joined, and also target and actual of one thing. */
internal fun groupsOf(graphs: List<Graph>): List<TopicGroup> = withTargets(byMeaning(graphs))

private fun byMeaning(graphs: List<Graph>): List<TopicGroup> {
    val lines = LinkedHashMap<Pair<String, Boolean>, MutableList<GraphSeries>>()
    val own = HashMap<Pair<String, Boolean>, Graph>()
    for (graph in graphs) {
        val line = graph.series[0]
        val isPlain = graph.series.size == 1 && !graph.isVirtual && !graph.isFilled && !graph.includesZero
        if (!isPlain) {
            // No topic has such a name, so that nothing is joined with it.
            val key = "${graph.name}\n${own.size}" to false
            own[key] = graph
            lines[key] = graph.series.toMutableList()
        } else {
            lines.getOrPut(graphNameOf(line.topic) to (line.states != null)) { ArrayList() } += line
        }
    }
    return lines.flatMap { (key, members) ->
        val graph = own[key]
        val name = if (key.second && (key.first to false) in lines) "${key.first} states" else key.first
        when {
            graph != null -> listOf(TopicGroup(graph.name, members, graph))

            members.size == 1 -> listOf(TopicGroup(members[0].topic.name, members))

            else -> inParts(members).mapIndexed { i, part ->
                TopicGroup(if (i == 0) name else "$name (${i + 1})", part, isTogether = true)
            }
        }
    }
}

/** Returns [items] in parts that fit in a graph. Does not use `chunked`, which adds 2 kB of coroutines to a page. */
internal fun <T> inParts(items: List<T>): List<List<T>> =
    (items.indices step MAX_LINES).map { items.subList(it, minOf(it + MAX_LINES, items.size)) }

/** Returns [groups] with target and actual of one thing joined, see [TargetName]. */
internal fun withTargets(groups: List<TopicGroup>): List<TopicGroup> {
    val things = groups.map { group -> if (group.own == null) TargetName.of(group.name) else null }
    val actuals = HashMap<List<String>, MutableList<Int>>()
    things.forEachIndexed { i, thing -> if (thing != null && !thing.isTarget) actuals.getOrPut(thing.words) { ArrayList() } += i }
    val joined = HashMap<Int, MutableList<TopicGroup>>()
    val gone = HashSet<Int>()
    things.forEachIndexed { i, target ->
        if (target == null || !target.isTarget) return@forEachIndexed
        val alike = actuals[target.words].orEmpty().firstOrNull { fit(groups[it], groups[i]) }
        val partner = alike ?: if (target.isBare) measuredIn(groups, things, i) else null
        if (partner == null) return@forEachIndexed
        val others = joined.getOrPut(partner) { ArrayList() }
        if (groups[partner].lines.size + groups[i].lines.size + others.sumOf { it.lines.size } > MAX_LINES) return@forEachIndexed
        others += groups[i]
        gone += i
    }
    return groups.mapIndexedNotNull { i, group ->
        val targets = joined[i].orEmpty()
        when {
            i in gone -> null
            targets.isEmpty() -> group
            else -> TopicGroup(group.name, group.lines + targets.flatMap { it.lines }, isTogether = true)
        }
    }
}

/**
 * Returns the measured value in the folder of the bare target [target]. For example `Arm/Angle` for `Arm/Goal`; null if there is not
 * exactly one.
 */
private fun measuredIn(groups: List<TopicGroup>, things: List<TargetName?>, target: Int): Int? = groups.indices.singleOrNull { i ->
    val name = groups[i].name
    things[i]?.isTarget == false && groups[i].lines.size == 1 && fit(groups[i], groups[target]) &&
        groups[i].folder == groups[target].folder && PathName.baseNameOf(name).lowercase() in MEASURED
}

private fun fit(one: TopicGroup, other: TopicGroup): Boolean {
    val unit = one.lines[0].unit
    val otherUnit = other.lines[0].unit
    return one.showsStates == other.showsStates && (unit == otherUnit || Units.isNone(unit) || Units.isNone(otherUnit))
}

/** The maximum number of lines in one graph that people can distinguish by hiding some. */
internal const val MAX_LINES = 16

private val MEASURED = setOf("position", "angle", "height", "velocity", "speed")
