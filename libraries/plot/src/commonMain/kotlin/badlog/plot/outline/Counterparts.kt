package badlog.plot.outline

import badlog.analysis.LogView

/**
 * The topic [name] of [view] with what is target or actual of the same thing, in the order in which they share a graph: what came of it,
 * then what was wanted. The name alone where there is nothing of that sort.
 */
public fun withCounterparts(view: LogView, name: String): List<String> {
    val all = view.recording.topics.map { TopicGroup(it.name, listOf(view.seriesOf(it))) }
    val present = all.filter { it.name == name || !it.lines[0].isEmpty }
    val together = withTargets(present).firstOrNull { group -> group.lines.any { it.topic.name == name } }
    return together?.lines?.map { it.topic.name } ?: listOf(name)
}
