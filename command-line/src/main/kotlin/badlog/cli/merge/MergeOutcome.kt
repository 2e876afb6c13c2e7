package badlog.cli.merge

import badlog.cli.command.Outcome
import badlog.cli.output.LeftOut
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.json
import badlog.cli.text.shortNumber
import badlog.cli.text.wrapped
import badlog.recording.RecordingFormat
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.nio.file.Path

/** What to say about [merge], which was written to [target] without [leftOut]. */
internal fun mergeOutcome(merge: Merged, target: Path, leftOut: LeftOut): Outcome {
    val recording = merge.recording
    val parts = merge.groups.flatMap { it.parts }
    val salvaged = parts.filter { it.recording.isSalvaged }
        .map { wrapped("  salvaged: ", "${it.file}; badlog info tells what is lost", INDENT) }
    val text = listOf("-> $target") + textLines(merge, leftOut) + leftOut.lines + salvaged
    val repeated = merge.groups.sumOf { it.repeated }
    val hasRows = recording.format != RecordingFormat.WPILOG
    val json = mapOf(
        "rows" to JsonPrimitive(recording.rowCount),
        "samples" to JsonPrimitive(recording.sampleCount),
        "topics" to JsonPrimitive(recording.topics.size),
        "logs" to JsonArray(merge.groups.map { group -> json(group.parts.map { it.file.toString() }) }),
        "overlaps" to JsonArray(merge.groups.flatMap { it.overlaps }.map(::overlapJson)),
        "repeatedRows" to JsonPrimitive(if (hasRows) repeated else 0),
        "repeatedSamples" to JsonPrimitive(if (hasRows) 0 else repeated),
        "renamed" to JsonArray(merge.renamed.map(::renamingJson)),
        "leftOut" to json(leftOut.all),
    )
    return Outcome(parts.any { it.recording.isSalvaged }, text.joinToString("\n"), json)
}

private fun textLines(merge: Merged, leftOut: LeftOut): List<String> = buildList {
    val recording = merge.recording
    val noun = if (recording.format == RecordingFormat.WPILOG) "sample" else "row"
    val count = if (recording.format == RecordingFormat.WPILOG) recording.sampleCount else recording.rowCount.toLong()
    add("  " + counted(count, noun) + " of " + counted(recording.topics.size.toLong(), "topic") + leftOut.tail)
    merge.groups.forEachIndexed { index, group ->
        val how = when {
            index > 0 -> "  beside them: "
            group.parts.size > 1 -> "  in the order of x: "
            else -> "  "
        }
        add(wrapped(how, group.parts.joinToString { part -> part.file.toString() + rangeOf(part) }, INDENT))
        for (overlap in group.overlaps) {
            val (one, other) = overlap.one.file to overlap.other.file
            add(wrapped("  overlap: ", "$one and $other from ${shortNumber(overlap.from)} to ${shortNumber(overlap.to)}", INDENT))
        }
        if (group.repeated > 0) add("  ${counted(group.repeated.toLong(), noun)} that several have kept once")
    }
    for (renaming in merge.renamed.take(LISTED)) {
        add(wrapped("  renamed: ", "“${renaming.from}” of ${renaming.part.file} is “${renaming.to}”", INDENT))
    }
    if (merge.renamed.size > LISTED) add("  renamed: ${grouped((merge.renamed.size - LISTED).toLong())} more in the same way")
}

private fun rangeOf(part: LogPart): String = if (part.firstX.isNaN()) "" else " (${shortNumber(part.firstX)} to ${shortNumber(part.lastX)})"

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
private const val LISTED = 10
