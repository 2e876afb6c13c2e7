package badlog.cli.output

import badlog.bag.RecordingWriter
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.recording.Topic
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
    ;

    /** What `--to` calls it. */
    val option: String get() = name.lowercase()

    /**
     * Writes the header of [recording] and the rows of [runs], which ascend.
     *
     * @param progress hears how many rows are written.
     */
    fun write(recording: Recording, runs: List<IntRange>, progress: (Int) -> Unit, sink: (ByteArray, Int) -> Unit) {
        val writer = RecordingWriter(recording, recordingFormat)
        var headerSize = 0
        writer.write(0, 0) { bytes, size ->
            headerSize += size
            sink(bytes, size)
        }
        var done = 0
        for (run in runs) {
            // Each time the writer begins with the header, which stands there once.
            var skipped = 0
            val base = done
            writer.write(run.first, run.last + 1, { rows, _ -> progress(base + rows) }) { bytes, size ->
                val skip = minOf(headerSize - skipped, size)
                skipped += skip
                if (skip < size) sink(if (skip == 0) bytes else bytes.copyOfRange(skip, size), size - skip)
            }
            done += run.count()
        }
    }

    /** What of [recording] this format has no place for, each as a short text. */
    fun leftOut(recording: Recording): List<String> {
        if (this != CSV) return emptyList()
        val topics = recording.topics
        return listOfNotNull(
            counted(topics.count { it.unit.isNotEmpty() && it.unit != Topic.UNITLESS }, "unit"),
            counted(topics.sumOf { it.attributes.size }, "attribute"),
            counted(recording.values.size, "value"),
        )
    }

    companion object {
        /** The format that a file's name asks for, or null when it tells none. */
        fun ofName(path: Path): LogFormat? = FileName.of(path).let { name ->
            entries.find { it.ending == name.ending.lowercase() } ?: BAG.takeIf { name.ending.lowercase() == ".badbag" }
        }

        /** The format that is nearest to what [recording] was read from. */
        fun of(recording: Recording): LogFormat =
            entries.find { it.recordingFormat == recording.format } ?: BAG

        private fun counted(count: Int, noun: String) = when (count) {
            0 -> null
            1 -> "1 $noun"
            else -> "$count ${noun}s"
        }
    }
}
