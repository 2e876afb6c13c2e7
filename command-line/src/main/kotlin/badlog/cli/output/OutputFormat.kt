package badlog.cli.output

import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.topic.part
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.formats.wpilog.WpilogFormat
import badlog.formats.wpilog.WpilogWriter
import java.nio.file.Path

/**
 * A format in which logs can be written. To add one, add a case here with its writer.
 *
 * @property ending the ending of such files' names.
 */
internal enum class OutputFormat(val ending: String, private val recordingFormat: RecordingFormat) {
    /** A line of JSON, then CSV. */
    BAG(".bag", RecordingFormat.BAG),

    /** CSV alone. */
    CSV(".csv", RecordingFormat.CSV),

    /** The log of WPILib's DataLog. */
    WPILOG(".wpilog", WpilogFormat),
    ;

    /** Its name for `--to`. */
    val option: String get() = name.lowercase()

    /** Whether a log of this format has rows. */
    val hasRows: Boolean get() = this != WPILOG

    /**
     * Writes the rows [runs] of [recording], which must ascend. For a recording without rows, writes all samples; then the format must be
     * one without rows.
     *
     * @param changesOnly whether to skip a sample that equals the previous one; only in a format without rows.
     * @param progress called with the amount written so far, and the total.
     * @return the content that this format cannot express.
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
     * Checks that [recording] can be written to [target] in this format.
     *
     * @throws Failure if it has no rows, which this format needs.
     */
    fun require(recording: Recording, target: Path) {
        if (!hasRows || recording.format.hasRows) return
        throw Failure(
            "$target needs rows, which the log does not have; use a name that ends in .wpilog, then badlog convert --to $option.",
        )
    }

    companion object {
        /** Returns the format for a file's name, or null if it has none. */
        fun ofName(path: Path): OutputFormat? = FileName.of(path).let { name ->
            entries.find { it.ending == name.ending.lowercase() } ?: BAG.takeIf { name.ending.lowercase() == ".badbag" }
        }

        /** Returns the format of the file that [recording] was read from, or else WPILOG. */
        fun of(recording: Recording): OutputFormat = entries.find { it.recordingFormat == recording.format } ?: WPILOG

        /**
         * Returns the name of a log made from [recording]. It is the name of its [file], with another ending if its format cannot be
         * written.
         */
        fun nameFor(file: Path, recording: Recording): FileName = FileName.of(file).let { name ->
            if (entries.any { it.recordingFormat == recording.format }) name else name.like(of(recording).ending)
        }
    }
}

/** Writes the rows [runs] of [recording], or all samples of one without rows, as a WPILOG. Returns the omissions. */
internal fun writeSamples(
    recording: Recording,
    runs: List<IntRange>,
    changesOnly: Boolean,
    progress: (done: Long, total: Long) -> Unit,
    sink: (ByteArray, Int) -> Unit,
): Omissions = Omissions(omissions = WpilogWriter(recording.part(runs), changesOnly).write(progress, sink))
