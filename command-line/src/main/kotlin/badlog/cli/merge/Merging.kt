package badlog.cli.merge

import badlog.catalog.match.FileForZip
import badlog.catalog.match.writeMatchZip
import badlog.cli.input.Failure
import badlog.cli.input.folderBeside
import badlog.cli.output.OutputFormat
import badlog.cli.output.writeLog
import badlog.files.terminal.Progress
import badlog.files.writeAtomically
import badlog.signals.match.files.FileRole
import badlog.signals.match.files.MatchFile
import badlog.signals.match.files.matchesOf
import java.nio.file.Files
import java.nio.file.Path

/**
 * The way to make one log of several.
 *
 * @param station the folder to search for the Driver Station log to put beside the robot's log; empty for the log's own folder, null for
 *   none.
 * @param acceptsOnly whether to accept the only Driver Station log there, regardless of its clock, unless its match contradicts.
 */
internal class Merging(
    private val mode: MergeMode,
    private val clocks: ClockChoice,
    private val station: Path?,
    private val acceptsOnly: Boolean,
) {
    private val finder = StationFinder()

    /** Whether to look for other logs of the match. */
    val findsMore: Boolean get() = station != null

    /**
     * Writes one log of [logs] to [target]. Their order counts only if none has an x axis.
     *
     * @param near other logs, which become part of a ZIP if they surely belong to the same match.
     * @throws Failure if they cannot become one.
     */
    fun write(logs: List<LogPart>, target: Path, progress: Progress, near: List<LogPart> = emptyList()): MergeResult {
        val sorted = if (logs.all { it.hasRows && it.xTopic == null }) logs else logs.sortedWith(PART_ORDER)
        if (sorted.isEmpty()) throw Failure("Merging needs at least two logs, but there is none.")
        val found = station?.let { stationFor(sorted, it) }
        val twin = found?.let { sorted.find { part -> Files.isSameFile(part.file, found.part.file) } }
        // A log that is given is not added a second time, and a place that is given counts.
        val beside = found.takeUnless { twin != null && clocks.isGiven(twin) }
        val given = (if (beside == null) sorted else sorted - setOfNotNull(twin)) + listOfNotNull(beside?.part)
        val (more, doubts) = if (near.isEmpty()) emptyList<LogPart>() to emptyList() else surelyOf(given, near)
        val parts = given + more
        if (parts.size < 2 && !parts[0].isMatch) throw Failure("Merging needs at least two logs, but there is one.")
        val moved = clocks.moved(parts, beside)
        return if (isZip(target)) zipped(parts, moved, target, doubts) else merge(moved, target, progress)
    }

    /** Returns the logs among [near] that surely belong to the match of [given], and a sentence about each of the others. */
    private fun surelyOf(given: List<LogPart>, near: List<LogPart>): Pair<List<LogPart>, List<String>> {
        val found = matchesOf((given + near).map { MatchFile("${it.file}", it.role, clocked(it)) })
        val names = found.matches.singleOrNull()?.parts.orEmpty().mapTo(HashSet()) { it.file.name }
        val (sure, others) = near.partition { "${it.file}" in names }
        val doubts = others.map { part ->
            found.left.find { (file, _) -> file.name == "${part.file}" }?.second
                ?: "${part.file} may be of another match; to add it, name it as a log."
        }
        return sure to doubts
    }

    /** Writes the robot's log and the Driver Station log of [beside] to [target], as one log. */
    fun write(beside: StationPart, target: Path, progress: Progress): MergeResult =
        merge(clocks.moved(listOf(beside.robot, beside.part), beside), target, progress)

    /** Returns the Driver Station log of the same match as [log]; null if there is none. */
    fun stationOf(log: LogPart): StationPart? = station?.let { finder.find(log, folderBeside(log.file, it), acceptsOnly) }

    private fun stationFor(logs: List<LogPart>, folder: Path): StationPart {
        val robots = logs.filter { it.role == FileRole.ROBOT && !it.isMatch }
        // A camera's log, for example, does not show when the robot was enabled.
        val robot = robots.find { clocked(it).edges.isNotEmpty() } ?: robots.firstOrNull()
            ?: throw Failure("--with-ds needs a robot's log; name one.")
        return finder.of(robot, folderBeside(robot.file, folder), acceptsOnly, robots.map { it.file })
    }

    /** Topics keep times of their own if one log has them, or the result can. */
    private fun merge(moved: MovedLogs, target: Path, progress: Progress): MergeResult {
        val parts = moved.parts
        val wanted = OutputFormat.ofName(target)
        if (parts.all { it.hasRows } && wanted?.hasRows != false) {
            val merged = Merge(parts, mode).merged()
            val format = wanted ?: OutputFormat.of(merged.recording)
            return MergeResult.Made(merged, moved, target, writeLog(merged.recording, format, target, progress = progress))
        }
        parts.find { !it.hasRows }?.let { wanted?.require(it.recording, target) }
        val records = MergedRecords(parts.map { it.withOwnTimes() }, mode)
        val merged = records.write(target, progress)
        return MergeResult.Made(merged, moved, target, records.leftOut)
    }

    /** The files of [parts] stay as they are, with the known clocks beside them. */
    private fun zipped(parts: List<LogPart>, moved: MovedLogs, target: Path, doubts: List<String>): MergeResult {
        moved.parts.find { it.isMatch }?.let { throw Failure("${it.file} consists of several logs; name them to make one ZIP of all.") }
        val known = (moved.placed + leadIn(moved)).toMutableSet()
        do {
            val more = moved.besides.filter { (part, beside) -> part !in known && beside in known }.keys
            known += more
        } while (more.isNotEmpty())
        // Nothing of the other logs is before 0 on the earliest clock.
        val first = moved.parts.filter { it.role == FileRole.ROBOT && it in known }.minBy { it.offset }
        // A given clock has no error that is known.
        val errors = moved.moves.associate { it.part to it.error.takeIf { error -> it.edges > 1 || error > 0 } }
        val files = moved.parts.map { part ->
            FileForZip(part.file, part.role, (part.offset - first.offset).takeIf { part in known }, errors[part])
        }
        requireOneMatch(parts, files)
        writeAtomically(target) { writeMatchZip(files, it) }
        return MergeResult.Zipped(moved, target, moved.parts.filter { it !in known }, doubts)
    }

    /**
     * Makes sure that the ZIP of [parts], which are as in their [files], opens with all of them.
     *
     * @throws Failure if nothing shows how their clocks fit.
     */
    private fun requireOneMatch(parts: List<LogPart>, files: List<FileForZip>) {
        val found = matchesOf(
            parts.zip(files) { part, file -> MatchFile("${part.file}", part.role, clocked(part), file.seconds, file.error) },
        )
        val (other, why) = found.left.firstOrNull()
            ?: found.matches.getOrNull(1)?.robot?.let { it to "It is not certain how the clock of ${it.name} fits the other logs." }
            ?: return
        val remedy = " For a ZIP that opens as one match, use --align enabled, or --offset ${other.name}=SECONDS."
        throw Failure(why + if (other.log.hasClock) remedy else "")
    }

    /** Returns the log of a robot that has the clock of the match. It is one that was not moved, if there is one. */
    private fun leadIn(moved: MovedLogs): LogPart {
        val robots = moved.parts.filter { it.role == FileRole.ROBOT }
        val kept = robots.filter { it.offset == 0.0 }.ifEmpty { robots }
        return kept.find { clocked(it).edges.isNotEmpty() } ?: kept.firstOrNull()
            ?: throw Failure("A ZIP of a match needs a robot's log, because the match has its clock; name one.")
    }
}

/** Whether [target] is to be a ZIP of the logs as they are. */
internal fun isZip(target: Path): Boolean = target.toString().endsWith(".zip", ignoreCase = true)
