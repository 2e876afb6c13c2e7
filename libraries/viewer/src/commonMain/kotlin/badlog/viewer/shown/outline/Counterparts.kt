package badlog.viewer.shown.outline

import badlog.core.analysis.LogView

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
