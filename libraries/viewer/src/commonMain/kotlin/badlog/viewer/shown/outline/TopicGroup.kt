package badlog.viewer.shown.outline

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.recording.PathName
import badlog.core.recording.TopicKind
import badlog.signals.vocabulary.TARGET_WORDS
import badlog.signals.vocabulary.wordsOf
import badlog.viewer.shown.search.Trait

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

/**
 * The meaning of a topic's name, and whether the topic is a target or an actual value. Two topics are target and actual of one thing if
 * their [words] are the same and one of them [isTarget]:
 *
 * - A name is split into words, including the words of its folders: `Chassis/ActualFrontLeft/speed` is *chassis actual front left speed*.
 * - One of the [TARGET_WORDS] makes it a target; that word is dropped: *chassis front left speed*. A name with two is neither.
 * - One of the [ACTUALS] is dropped from any other name. *Current* counts only before the word it describes, as in *current angle*: at
 *   the end of a name, it means amperes.
 *
 * @property words the remaining words of the name, in lower case.
 * @property isTarget whether the name says that this is a target.
 * @property isBare whether the last part of the name has no other meaning, as in `Arm/Goal`.
 */
internal class TargetName private constructor(val words: List<String>, val isTarget: Boolean, val isBare: Boolean) {
    companion object {
        /** Returns the meaning of [name]; null if it is not clear. */
        fun of(name: String): TargetName? {
            val words = wordsOf(name)
            val targets = words.indices.filter { words[it] in TARGET_WORDS }
            if (targets.size > 1) return null
            val target = targets.firstOrNull()
            if (target != null) {
                return TargetName(words.without(target), isTarget = true, isBare = wordsOf(name.substringAfterLast('/')).size == 1)
            }
            val actual = words.indices.singleOrNull { words[it] in ACTUALS && (words[it] != CURRENT || it < words.lastIndex) }
            return TargetName(if (actual == null) words else words.without(actual), isTarget = false, isBare = false)
        }

        private fun List<String>.without(index: Int) = filterIndexed { i, _ -> i != index }

        private const val CURRENT = "current"

        /** Words for an actual value. */
        private val ACTUALS = setOf("actual", "actuals", "measured", "measurement", "current", "observed", "feedback", "estimated")
    }
}

/**
 * Returns the topic [name] of [view] with its counterpart, the target or actual value of the same thing. They are in the order in which
 * they share a graph: actual, then target. Without a counterpart, the result is only the name.
 */
fun withCounterparts(view: LogView, name: String): List<String> {
    val all = view.recording.topics.map { TopicGroup(it.name, listOf(view.seriesOf(it))) }
    val present = all.filter { it.name == name || !it.lines[0].isEmpty }
    val together = withTargets(present).firstOrNull { group -> group.lines.any { it.topic.name == name } }
    return together?.lines?.map { it.topic.name } ?: listOf(name)
}

/** The traits of this line that a search can use, except whether there is a finding. Examines its samples. */
val GraphSeries.traits: Set<Trait>
    get() = buildSet {
        when {
            isEmpty -> add(Trait.EMPTY)
            states != null -> add(Trait.STATE)
            topic.kind == TopicKind.EVENT -> add(Trait.EVENT)
            else -> add(Trait.NUMBER)
        }
        if (Trait.EMPTY !in this && topic.kind != TopicKind.EVENT && !everChanges(topic)) add(Trait.CONSTANT)
    }
