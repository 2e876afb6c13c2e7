package badlog.cli.merge

import badlog.cli.input.Failure
import badlog.cli.topic.CellSource
import badlog.cli.topic.TopicBuilder
import badlog.core.analysis.Units
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Topic

/**
 * Makes one recording of [parts], two or more, which must all have rows.
 *
 * @throws Failure if their rows have no common clock.
 */
internal class Merge(parts: List<LogPart>, mode: MergeMode) {
    private val groups: List<AppendedRows> = mode.groupsOf(parts).map(::AppendedRows)
    private val joined: JoinedRows
    private val first = parts.first()

    // The x topic of all; null if x is the row's index.
    private val xTopic: Topic?

    private val names = MergedNames()
    private val valueNames = MergedNames()

    init {
        requireOneClock(parts)
        joined = JoinedRows(if (groups.size > 1) groups else groups.take(1))
        xTopic = groups.first().parts.first().xTopic
    }

    /** Returns the result. Call it once. */
    fun merged(): Merged {
        val topics = groups.flatMapIndexed { index, group -> topicsOf(index, group) }
        val format = if (first.recording.format == RecordingFormat.CSV && groups.all { group -> group.parts.all(::isCsv) }) {
            RecordingFormat.CSV
        } else {
            RecordingFormat.BAG
        }
        val values = valueNames.values(groups.flatMap { it.parts })
        return Merged(
            Recording(format, first.recording.headerLine, values, topics, joined.size, emptyList()),
            groups.map { Merged.Group(it.parts, it.repeated) },
            names.renamed + valueNames.renamed,
        )
    }

    private fun isCsv(part: LogPart) = part.recording.format == RecordingFormat.CSV

    private fun topicsOf(groupIndex: Int, group: AppendedRows): List<Topic> {
        val x = group.parts.first().xTopic
        return namesOf(group).mapNotNull { name ->
            when {
                x == null || name != x.name -> topic(groupIndex, group, name)
                groupIndex == 0 -> xTopic(x).also { names.take(name, group.parts.first()) }
                else -> null
            }
        }
    }

    /**
     * Returns the topics of [group]: first the topics of its first log, then the ones that others add. Only the x topic of the first log is
     * included.
     */
    private fun namesOf(group: AppendedRows): Set<String> {
        val names = group.parts.first().recording.topics.mapTo(LinkedHashSet()) { it.name }
        for (part in group.parts.drop(1)) part.recording.topics.filter { it !== part.xTopic }.mapTo(names) { it.name }
        return names
    }

    private fun xTopic(like: Topic): Topic {
        val merged = TopicBuilder(like.name, like, joined.size)
        for (row in 0 until joined.size) joined.x(row).let { if (it.isNaN()) merged.addEmpty() else merged.addNumber(it, like) }
        return merged.build()
    }

    private fun topic(groupIndex: Int, group: AppendedRows, name: String): Topic {
        val part = group.parts.first { it.topic(name) != null }
        val merged = TopicBuilder(names.take(name, part), checkNotNull(part.topic(name)), joined.size)
        val sources = group.parts.map { CellSource(it.topic(name)) }
        for (row in 0 until joined.size) {
            val index = joined.rowOf(groupIndex, row)
            if (index == JoinedRows.NONE) merged.addEmpty() else sources[group.partOf(index)].addTo(merged, group.rowOf(index))
        }
        return merged.build()
    }

    private fun requireOneClock(parts: List<LogPart>) {
        val withoutX = parts.filter { it.xTopic == null }
        if (withoutX.isEmpty()) {
            val unit = first.xTopic?.unit.orEmpty()
            val other = parts.find { isOther(it.xTopic?.unit.orEmpty(), unit) } ?: return
            throw Failure("${other.file} counts x in ${other.xTopic?.unit}, but ${first.file} in $unit; these are not one clock.")
        }
        if (groups.size == 1 && withoutX.size == parts.size) return
        throw Failure("${withoutX[0].file} has no x axis, so its rows cannot be placed; name the time topic with --x.")
    }

    private fun isOther(unit: String, than: String) = unit != than && !Units.isNone(unit) && !Units.isNone(than)
}

/** The ways to make one log of several. */
internal enum class MergeMode {
    /** Logs with the same topics one after the other, then these groups side by side. */
    BY_TOPICS,

    /** All logs one after the other; topics that a log lacks are empty there. */
    APPEND,

    /** All logs side by side. */
    JOIN,
    ;

    /** Returns [parts] in groups: logs in one group follow each other, and groups are side by side. */
    fun groupsOf(parts: List<LogPart>): List<List<LogPart>> = when (this) {
        APPEND -> listOf(parts)
        JOIN -> parts.map(::listOf)
        BY_TOPICS -> parts.groupBy { part -> part.recording.topics.mapTo(HashSet()) { it.name } }.values.toList()
    }
}
