package badlog.cli.merge

import badlog.cli.command.Outcome
import badlog.cli.output.Omissions
import badlog.cli.text.JsonNumber
import badlog.cli.text.XTime
import badlog.cli.text.counted
import badlog.cli.text.grouped
import badlog.cli.text.jsonOf
import badlog.cli.text.shortNumber
import badlog.cli.text.wrapped
import kotlinx.serialization.Serializable
import java.nio.file.Path

/** Returns the outcome of [merge] of the logs [moved], which was written to [target] without [leftOut]. */
internal fun mergeOutcome(merge: Merged, moved: MovedLogs, target: Path, leftOut: Omissions): Outcome {
    val recording = merge.recording
    val parts = merge.groups.flatMap { it.parts }
    val salvaged = parts.filter { it.recording.isSalvaged }
        .map { wrapped("  salvaged: ", "${it.file}; badlog info shows what is lost", INDENT) }
    val lacking = parts.flatMap { it.recording.leftOutLogs }
    val text = listOf("-> $target") + textLines(merge, leftOut) + clockLines(moved.moves, moved.pauses) + leftOut.lines + salvaged +
        lacking.map { wrapped("  left out: ", it, INDENT) }
    val repeated = merge.groups.sumOf { it.repeated }
    val hasRows = recording.format.hasRows
    val json = MergeJson(
        rows = recording.rowCount,
        samples = recording.sampleCount,
        topics = recording.topics.size,
        logs = merge.groups.map { group -> group.parts.map { it.file.toString() } },
        overlaps = merge.groups.flatMap { it.overlaps }.map(::OverlapJson),
        repeatedRows = if (hasRows) repeated else 0,
        repeatedSamples = if (hasRows) 0 else repeated,
        renamed = merge.renamed.map(::RenamingJson),
        leftOut = leftOut.all + lacking,
        moved = moved.moves.map(::MoveJson),
        apart = moved.pauses.map(::PauseJson),
    )
    return Outcome(parts.any { it.recording.isSalvaged }, text.joinToString("\n"), jsonOf(json))
}

/**
 * Returns the outcome of writing the logs [moved], as they are, to the ZIP [target]. It does not state the clocks of the logs [open].
 *
 * @param doubts a sentence about each log near them that is left out.
 */
internal fun zipOutcome(moved: MovedLogs, target: Path, open: List<LogPart>, doubts: List<String>): Outcome {
    val count = counted(moved.parts.size.toLong(), "log")
    val text = listOf("-> $target", "  $count, unchanged, with the clocks in match.json") + clockLines(moved.moves, moved.pauses) +
        open.map { wrapped("  open: ", "${it.file}; its clock is found when the ZIP is read, or given by --align or --offset", INDENT) } +
        doubts.map { wrapped("  left out: ", it, INDENT) }
    val json = ZipJson(
        moved.parts.map { it.file.toString() },
        moved.moves.map(::MoveJson),
        moved.pauses.map(::PauseJson),
        open.map { it.file.toString() },
        doubts,
    )
    return Outcome(isSalvaged = false, text.joinToString("\n"), jsonOf(json))
}

private fun textLines(merge: Merged, leftOut: Omissions): List<String> = buildList {
    val recording = merge.recording
    val noun = if (recording.format.hasRows) "row" else "sample"
    val count = if (recording.format.hasRows) recording.rowCount.toLong() else recording.sampleCount
    add("  " + counted(count, noun) + " of " + counted(recording.topics.size.toLong(), "topic") + leftOut.tail)
    merge.groups.forEachIndexed { index, group ->
        val how = when {
            index > 0 -> "  joined: "
            group.parts.size > 1 && group.parts.all { it.hasRows && it.xTopic == null } -> "  in the order given: "
            group.parts.size > 1 -> "  in order of x: "
            else -> "  "
        }
        add(wrapped(how, group.parts.joinToString { part -> part.file.toString() + rangeOf(part) }, INDENT))
        for (overlap in group.overlaps) {
            val (one, other) = overlap.one.file to overlap.other.file
            add(wrapped("  overlap: ", "$one and $other from ${shortNumber(overlap.from)} to ${shortNumber(overlap.to)}", INDENT))
        }
        if (group.repeated > 0) add("  ${counted(group.repeated.toLong(), "duplicate $noun")}, kept once")
    }
    addAll(renamedLines(merge))
}

/** Returns a line for each topic and value that was renamed. */
internal fun renamedLines(merge: Merged): List<String> = buildList {
    for (renaming in merge.renamed.take(LISTED)) {
        val why = if (renaming.reason.isEmpty()) "" else "; ${renaming.reason}"
        add(wrapped("  renamed: ", "“${renaming.from}” of ${renaming.part.file} is “${renaming.to}”$why", INDENT))
    }
    if (merge.renamed.size > LISTED) add("  renamed: ${grouped((merge.renamed.size - LISTED).toLong())} more in the same way")
}

/** Returns lines that describe [moves] and [pauses]. */
internal fun clockLines(moves: List<Move>, pauses: List<Pause>): List<String> = moves.map { move ->
    val by = "${move.part.file} by ${shortNumber(move.part.offset, DIGITS)} s"
    val how = when (move.edges) {
        0 -> if (move.error > 0) "; aligned by the clocks, to about ${shortNumber(move.error, ERROR_DIGITS)} s" else ""
        1 -> "; one edge of ${move.what} fits, which may be chance"
        else -> "; ${move.edges} edges of ${move.what} fit within ${shortNumber(move.error, ERROR_DIGITS)} s"
    }
    val early = if (move.early == 0L) "" else "; without ${counted(move.early, "sample")} before 0"
    wrapped("  moved: ", by + how + early, INDENT)
} + pauses.map { pause ->
    val text = "${pause.one.file} ends ${XTime.clock(pause.seconds)} before ${pause.other.file} begins; if they were recorded together, " +
        "use --align enabled or --offset"
    wrapped("  apart: ", text, INDENT)
}

private fun rangeOf(part: LogPart): String = if (part.firstX.isNaN()) "" else " (${shortNumber(part.firstX)} to ${shortNumber(part.lastX)})"

@Serializable
private class MergeJson(
    private val rows: Int,
    private val samples: Long,
    private val topics: Int,
    private val logs: List<List<String>>,
    private val overlaps: List<OverlapJson>,
    private val repeatedRows: Int,
    private val repeatedSamples: Int,
    private val renamed: List<RenamingJson>,
    private val leftOut: List<String>,
    private val moved: List<MoveJson>,
    private val apart: List<PauseJson>,
)

@Serializable
private class ZipJson(
    private val logs: List<String>,
    private val moved: List<MoveJson>,
    private val apart: List<PauseJson>,
    private val open: List<String>,
    private val leftOut: List<String>,
)

@Serializable
private class MoveJson(
    private val log: String,
    private val seconds: JsonNumber,
    private val edges: Int,
    private val error: JsonNumber,
    private val early: Long,
) {
    constructor(move: Move) : this(move.part.file.toString(), move.part.offset, move.edges, move.error, move.early)
}

@Serializable
private class PauseJson(private val logs: List<String>, private val seconds: JsonNumber) {
    constructor(pause: Pause) : this(listOf(pause.one.file.toString(), pause.other.file.toString()), pause.seconds)
}

@Serializable
private class OverlapJson(private val logs: List<String>, private val from: JsonNumber, private val to: JsonNumber) {
    constructor(overlap: Overlap) :
        this(listOf(overlap.one.file.toString(), overlap.other.file.toString()), overlap.from, overlap.to)
}

@Serializable
private class RenamingJson(private val log: String, private val from: String, private val to: String, private val reason: String) {
    constructor(renaming: Renaming) : this(renaming.part.file.toString(), renaming.from, renaming.to, renaming.reason)
}

private const val INDENT = 4
private const val LISTED = 10
private const val DIGITS = 9
private const val ERROR_DIGITS = 2
