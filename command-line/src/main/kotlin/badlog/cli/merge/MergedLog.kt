package badlog.cli.merge

import badlog.catalog.match.MatchMaker
import badlog.cli.input.Failure
import badlog.core.recording.Problem
import badlog.files.LogMaker
import badlog.files.ReadResult
import badlog.files.UnreadableFileException
import badlog.files.isOfDriverStation
import badlog.files.readLog
import badlog.files.terminal.Progress
import badlog.formats.LOG_FORMATS
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/** Makes one log of [parts], which is read in place of [first]. */
internal class MergedLog(private val first: Path, private val parts: List<LogPart>, private val merging: Merging) : LogMaker {
    override fun isSource(file: Path, head: ByteArray): Boolean = file == first

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> {
        merged(file, parts, merging, made, checkpoint)
        return parts.flatMap { it.recording.problems }
    }
}

/** Puts beside each log of a robot the Driver Station's of its match; a log without one is read as it is. */
internal class LogBesideStation(private val merging: Merging) : LogMaker {
    // Whole logs of a folder would not fit into memory.
    private val haveStation = ConcurrentHashMap<Path, Boolean>()

    override fun isSource(file: Path, head: ByteArray): Boolean = MatchMaker.isSource(file, head) ||
        haveStation.getOrPut(file) { partOf(file)?.takeUnless { it.recording.isOfDriverStation }?.let(merging::hasStation) == true }

    override fun make(file: Path, made: Path, checkpoint: () -> Unit): List<Problem> {
        val part = partOf(file) ?: return MatchMaker.make(file, made, checkpoint)
        merged(file, listOf(part), merging, made, checkpoint)
        return part.recording.problems
    }

    private fun partOf(file: Path): LogPart? = (readLog(file, LOG_FORMATS) as? ReadResult.Read)?.let { LogPart(file, it.recording) }
}

private fun merged(file: Path, parts: List<LogPart>, merging: Merging, made: Path, checkpoint: () -> Unit) {
    try {
        merging.write(parts, made, Progress { _, _ -> checkpoint() })
    } catch (e: Failure) {
        throw UnreadableFileException(file, e.message)
    }
}
