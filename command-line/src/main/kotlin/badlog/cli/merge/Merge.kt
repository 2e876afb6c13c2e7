package badlog.cli.merge

import badlog.cli.Failure
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic
import badlog.recording.Value

/**
 * Makes one recording of [parts], two or more.
 *
 * @throws Failure when nothing tells how their rows belong together.
 */
internal class Merge(parts: List<LogPart>, mode: MergeMode) {
    /** The logs that stand side by side; those of one group one after the other. */
    val groups: List<AppendedRows>
    private val joined: JoinedRows
    private val first = parts.first()

    // The topic of x of all, or null where it is the row's index.
    private val xTopic: Topic?

    /** What is called otherwise than in its log: the log, the name there, and the new one. */
    val renamed = ArrayList<Renaming>()

    init {
        groups = when (mode) {
            MergeMode.APPEND -> listOf(parts)
            MergeMode.JOIN -> parts.map(::listOf)
            MergeMode.BY_TOPICS -> parts.groupBy { part -> part.recording.topics.mapTo(HashSet()) { it.name } }.values
        }.map(::AppendedRows)
        requireOneClock(parts)
        joined = JoinedRows(if (groups.size > 1) groups else groups.take(1))
        xTopic = groups.first().parts.first().xTopic
    }

    /** The merged recording. To be called once. */
    fun recording(): Recording {
        val taken = HashSet<String>()
        val topics = groups.flatMapIndexed { index, group -> topicsOf(index, group, taken) }
        val format = if (first.recording.format == RecordingFormat.CSV && groups.all { group -> group.parts.all(::isCsv) }) {
            RecordingFormat.CSV
        } else {
            RecordingFormat.BAG
        }
        return Recording(format, first.recording.headerLine, values(), topics, joined.size, emptyList())
    }

    private fun isCsv(part: LogPart) = part.recording.format == RecordingFormat.CSV

    private fun topicsOf(groupIndex: Int, group: AppendedRows, taken: MutableSet<String>): List<Topic> {
        val x = group.parts.first().xTopic
        return namesOf(group).mapNotNull { name ->
            when {
                x == null || name != x.name -> topic(groupIndex, group, name, taken)
                groupIndex == 0 -> xTopic(x).also { taken += name }
                else -> null
            }
        }
    }

    /** The topics of [group], in the order of its first log, then what others add; of x topics only that of the first. */
    private fun namesOf(group: AppendedRows): Set<String> {
        val names = group.parts.first().recording.topics.mapTo(LinkedHashSet()) { it.name }
        for (part in group.parts.drop(1)) part.recording.topics.filter { it !== part.xTopic }.mapTo(names) { it.name }
        return names
    }

    private fun xTopic(like: Topic): Topic {
        val merged = MergedTopic(like.name, like, joined.size)
        for (row in 0 until joined.size) joined.x(row).let { if (it.isNaN()) merged.addEmpty() else merged.addNumber(it, like) }
        return merged.build()
    }

    private fun topic(groupIndex: Int, group: AppendedRows, name: String, taken: MutableSet<String>): Topic {
        val part = group.parts.first { it.topic(name) != null }
        val merged = MergedTopic(freeName(name, part, taken), checkNotNull(part.topic(name)), joined.size)
        val sources = group.parts.map { CellSource(it.topic(name)) }
        for (row in 0 until joined.size) {
            val index = joined.rowOf(groupIndex, row)
            if (index == JoinedRows.NONE) merged.addEmpty() else sources[group.partOf(index)].addTo(merged, group.rowOf(index))
        }
        return merged.build()
    }

    private fun values(): List<Value> {
        val values = ArrayList<Value>()
        val taken = HashSet<String>()
        for (part in groups.flatMap { it.parts }) {
            for (value in part.recording.values) {
                if (value !in values) values += value.copy(name = freeName(value.name, part, taken))
            }
        }
        return values
    }

    /** [name], or where that is taken, [name] in a folder that is called like the file of [part]. */
    private fun freeName(name: String, part: LogPart, taken: MutableSet<String>): String {
        if (taken.add(name)) return name
        val inFolder = "${part.folder}/$name"
        val free = generateSequence(1) { it + 1 }.map { if (it == 1) inFolder else "$inFolder ($it)" }.first(taken::add)
        renamed += Renaming(part, name, free)
        return free
    }

    private fun requireOneClock(parts: List<LogPart>) {
        val withoutX = parts.filter { it.xTopic == null }
        if (withoutX.isEmpty()) {
            val unit = first.xTopic?.unit.orEmpty()
            val other = parts.find { isOther(it.xTopic?.unit.orEmpty(), unit) } ?: return
            throw Failure("${other.file} counts x in ${other.xTopic?.unit}, but ${first.file} in $unit; these are not one clock.")
        }
        if (groups.size == 1 && withoutX.size == parts.size) return
        throw Failure("${withoutX[0].file} has no x axis, so nothing tells where its rows belong; name the topic by --x.")
    }

    private fun isOther(unit: String, than: String) = unit != than && !isNone(unit) && !isNone(than)

    private fun isNone(unit: String) = unit.isEmpty() || unit == Topic.UNITLESS
}
