package badlog.cli.merge

import badlog.cli.Outcome
import badlog.cli.output.LogFormat
import badlog.cli.text.counted
import badlog.cli.text.json
import badlog.cli.text.shortNumber
import badlog.cli.text.wrapped
import badlog.recording.Recording
import java.nio.file.Path
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** What to say about [merge], which made [recording] of [parts] and wrote it to [target]. */
internal fun mergeOutcome(
    merge: Merge,
    parts: List<LogPart>,
    recording: Recording,
    target: Path,
    format: LogFormat,
): Outcome {
    val salvaged = parts.filter { it.recording.isSalvaged }
        .map { wrapped("  salvaged: ", "${it.file}; badlog info tells what is lost", INDENT) }
    val text = listOf("-> $target") + textLines(merge, recording) + salvaged + listOfNotNull(
        format.leftOut(recording).takeIf { it.isNotEmpty() }?.let { wrapped("  ", "without ${it.joinToString()}") },
    )
    val json = mapOf(
        "rows" to JsonPrimitive(recording.rowCount),
        "topics" to JsonPrimitive(recording.topics.size),
        "logs" to JsonArray(merge.groups.map { group -> json(group.parts.map { it.file.toString() }) }),
        "overlaps" to JsonArray(merge.groups.flatMap { it.overlaps() }.map(::overlapJson)),
        "repeatedRows" to JsonPrimitive(merge.groups.sumOf { it.repeated }),
        "renamed" to JsonArray(merge.renamed.map(::renamingJson)),
        "leftOut" to json(format.leftOut(recording)),
    )
    return Outcome(parts.any { it.recording.isSalvaged }, text.joinToString("\n"), json)
}

private fun textLines(merge: Merge, recording: Recording): List<String> = buildList {
    add("  " + counted(recording.rowCount.toLong(), "row") + " of " + counted(recording.topics.size.toLong(), "topic"))
    merge.groups.forEachIndexed { index, group ->
        val how = when {
            index > 0 -> "  beside them: "
            group.parts.size > 1 -> "  in the order of x: "
            else -> "  "
        }
        add(wrapped(how, group.parts.joinToString { part -> part.file.toString() + rangeOf(part) }, INDENT))
        for (overlap in group.overlaps()) {
            val (one, other) = overlap.one.file to overlap.other.file
            add(wrapped("  overlap: ", "$one and $other from ${shortNumber(overlap.from)} to ${shortNumber(overlap.to)}", INDENT))
        }
        if (group.repeated > 0) add("  ${counted(group.repeated.toLong(), "row")} that several have kept once")
    }
    for (renaming in merge.renamed) {
        add(wrapped("  renamed: ", "“${renaming.from}” of ${renaming.part.file} is “${renaming.to}”", INDENT))
    }
}

private fun rangeOf(part: LogPart): String =
    if (part.firstX.isNaN()) "" else " (${shortNumber(part.firstX)} to ${shortNumber(part.lastX)})"

private fun overlapJson(overlap: Overlap): JsonElement = JsonObject(
    mapOf(
        "logs" to json(listOf(overlap.one.file.toString(), overlap.other.file.toString())),
        "from" to json(overlap.from),
        "to" to json(overlap.to),
    ),
)

private fun renamingJson(renaming: Renaming): JsonElement = JsonObject(
    mapOf(
        "log" to JsonPrimitive(renaming.part.file.toString()),
        "from" to JsonPrimitive(renaming.from),
        "to" to JsonPrimitive(renaming.to),
    ),
)

private const val INDENT = 4
