package badlog.cli.output

import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.topic.part
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.wpilog.WpilogWriter
import java.nio.file.Path

/**
 * A format that logs can be written in. A new one is a case here, with what it needs to write.
 *
 * @property ending how the names of such files end.
 */
internal enum class LogFormat(val ending: String, private val recordingFormat: RecordingFormat) {
    /** A line of JSON, then CSV. */
    BAG(".bag", RecordingFormat.BAG),

    /** CSV alone. */
    CSV(".csv", RecordingFormat.CSV),

    /** The log of WPILib's DataLog. */
    WPILOG(".wpilog", RecordingFormat.WPILOG),
    ;

    /** What `--to` calls it. */
    val option: String get() = name.lowercase()

    /** Whether a log of this format has rows. */
    val hasRows: Boolean get() = this != WPILOG

    /**
     * Writes the rows [runs], which ascend, of [recording]; all samples of one that has no rows, which needs a format without.
     *
     * @param changesOnly whether a sample is left out that is the same as the one before it; only in a format without rows.
     * @param progress hears how much is written, and how much there is.
     * @return what this format has no place for.
     */
    fun write(
        recording: Recording,
        runs: List<IntRange>,
        changesOnly: Boolean,
        progress: (done: Long, total: Long) -> Unit,
        sink: (ByteArray, Int) -> Unit,
    ): Omissions = if (hasRows) {
        writeRows(recording, recordingFormat, runs, progress, sink)
    } else {
        writeSamples(recording, runs, changesOnly, progress, sink)
    }

    /**
     * Makes sure that [recording] can be written so, to [target].
     *
     * @throws Failure when it has no rows, which this format needs.
     */
    fun require(recording: Recording, target: Path) {
        if (!hasRows || recording.format.hasRows) return
        throw Failure(
            "$target needs rows, which the log does not have; use a name that ends in .wpilog, then badlog convert --to $option.",
        )
    }

    companion object {
        /** The format that a file's name asks for, or null when it has none. */
        fun ofName(path: Path): LogFormat? = FileName.of(path).let { name ->
            entries.find { it.ending == name.ending.lowercase() } ?: BAG.takeIf { name.ending.lowercase() == ".badbag" }
        }

        /** The format that is nearest to what [recording] was read from. */
        fun of(recording: Recording): LogFormat = entries.find { it.recordingFormat == recording.format } ?: WPILOG

        /** What a log that is made of [recording] is called: as its [file], where it is of the format that this is written in. */
        fun nameFor(file: Path, recording: Recording): FileName = FileName.of(file).let { name ->
            if (entries.any { it.recordingFormat == recording.format }) name else name.like(of(recording).ending)
        }
    }
}

/** Writes the rows [runs] of [recording], or all samples of one without rows, as a WPILOG; returns what that cannot carry. */
internal fun writeSamples(
    recording: Recording,
    runs: List<IntRange>,
    changesOnly: Boolean,
    progress: (done: Long, total: Long) -> Unit,
    sink: (ByteArray, Int) -> Unit,
): Omissions = Omissions(omissions = WpilogWriter(recording.part(runs), changesOnly).write(progress, sink))
