package badlog.cli.merge

import badlog.catalog.match.MatchMaker
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.output.OutputFormat
import badlog.cli.output.writeLog
import badlog.core.recording.Problem
import badlog.core.recording.ProblemKind
import badlog.files.LogMaker
import badlog.files.ReadResult
import badlog.files.UnreadableFileException
import badlog.files.readLog
import badlog.files.terminal.Progress
import badlog.files.writing
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.isOfDriverStation
import badlog.signals.clock.ClockFit
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.util.concurrent.ConcurrentHashMap

/**
 * The file [merged], which combines several logs and is read in place of [first].
 *
 * @param problems the problems of all the combined logs.
 */
internal class MergedLog private constructor(val first: Path, private val merged: Path, private val problems: List<Problem>) : LogMaker {
    override fun isSource(file: Path, head: ByteArray): Boolean = file == first

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> {
        checkpoint()
        writing(made) { Files.copy(merged, made, StandardCopyOption.REPLACE_EXISTING) }
        return problems
    }

    companion object {
        /**
         * Merges [parts] as [merging] says, into a file in [folder], and reports how they were moved.
         *
         * @param isJson whether to report only doubts.
         * @throws Failure if they cannot become one.
         */
        fun of(parts: List<LogPart>, merging: Merging, folder: Path, console: Console, isJson: Boolean): MergedLog {
            val first = parts.minWithOrNull(PART_ORDER)?.file ?: throw Failure("There is no log to read.")
            val target = folder.resolve("merged.wpilog")
            val result = console.progress("${first.fileName}").use { merging.write(parts, target, it) }
            result.remarks(isOfDoubts = isJson).forEach(console::warn)
            return MergedLog(first, target, result.problems)
        }
    }
}

/**
 * Puts beside each robot's log the Driver Station log of its match. A log without one is read as it is.
 *
 * @param isJson whether to report only doubts.
 * @param warn reports how logs were moved.
 */
internal class LogBesideStation(private val merging: Merging, private val isJson: Boolean, private val warn: (String) -> Unit) : LogMaker {
    /** Whole logs of a folder would not fit into memory. */
    private class Place(val station: Path, val fit: ClockFit)

    /** The place of each log; null in it for a log that has no Driver Station's. */
    private val places = ConcurrentHashMap<Path, List<Place>>()

    /** A log may be made several times, for its page and for hooks. */
    private val said = ConcurrentHashMap.newKeySet<String>()

    override fun isSource(file: Path, head: ByteArray): Boolean = MatchMaker.isSource(file, head) || placeOf(file) != null

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> {
        val place = placeOf(file)
        if (place == null) {
            say("$file: --with-ds has no effect on a ZIP or match.json; put the Driver Station's log into it.")
            return MatchMaker.make(file, made, checkpoint)
        }
        val part = readPart(file) ?: throw UnreadableFileException(file, "$file has changed while it was read; try again.")
        val progress = Progress { _, _ -> checkpoint() }
        try {
            val station = readPart(place.station) ?: throw Failure("${place.station} cannot be read.")
            val result = merging.write(StationPart(part, station, place.fit), made, progress)
            result.remarks(isOfDoubts = isJson).forEach(::say)
            return result.problems
        } catch (e: Failure) {
            writeLog(part.recording, OutputFormat.WPILOG, made, progress = progress)
            val message = "The Driver Station log ${place.station} is left out: ${e.message}"
            return part.recording.problems + Problem(ProblemKind.LOG_LEFT_OUT, message)
        }
    }

    private fun say(text: String) {
        if (said.add(text)) warn(text)
    }

    private fun placeOf(file: Path): Place? = places.computeIfAbsent(file) {
        val part = readPart(file)?.takeUnless { it.recording.isOfDriverStation }
        val station = try {
            part?.let(merging::stationOf).also {
                if (part != null && it == null) say("$file: no Driver Station log of its match was found, so it is shown as it is.")
            }
        } catch (e: Failure) {
            say(e.message)
            null
        }
        listOfNotNull(station?.let { Place(it.part.file, it.fit) })
    }.singleOrNull()

    private fun readPart(file: Path): LogPart? = (readLog(file, LOG_FORMATS) as? ReadResult.Read)?.let { LogPart(file, it.recording) }
}
