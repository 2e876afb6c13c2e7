package badlog.file

import badlog.bag.BagParser
import badlog.bag.RecordingParser
import badlog.recording.LogFormat
import badlog.recording.NumberSinks
import badlog.recording.ProblemKind
import badlog.recording.Recording
import java.nio.channels.FileChannel
import java.nio.file.Path

/**
 * Reads [file]: a bag, a CSV file or a log of one of [formats], perhaps compressed with gzip; its content decides, never its
 * name. Whatever is wrong in it becomes a problem of the recording. It is read on all cores. Besides the recording, it holds
 * less than 3 MB, and 1 MB for each core, whatever the file's size.
 *
 * @param formats what it may be besides a bag and a CSV file.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param untilLastLineEnd true to leave out what stands after the file's last line end, or all where there is none: the
 *   half of a row in a file that is still being written, and no problem. So is the half of a record at the end of a log of records.
 *   Without effect on a compressed file.
 * @param sinks where the numbers of a bag's or CSV file's topics go that the recording is not to have; texts and counts are in it
 *   all the same.
 * @param progress hears, on the calling thread and about once a megabyte, how many bytes of the file are read and how many
 *   it had at the beginning. What it throws stops the reading and is passed on.
 * @throws UnreadableFileException when the file is missing, is not a regular file, or cannot be read.
 * @throws InterruptedException when the thread was interrupted.
 */
public fun readRecording(
    file: Path,
    formats: List<LogFormat>,
    keepSamples: Boolean = true,
    untilLastLineEnd: Boolean = false,
    sinks: NumberSinks = NumberSinks.RECORDING,
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): Recording {
    requireRegularFile(file)
    return reading(file) { FileChannel.open(file) }.use { channel ->
        val pieces = FilePieces(file, channel, progress)
        fun threads(expectedBytes: Long) = ParsingThreads(formats, expectedBytes, keepSamples, sinks = sinks)
        val isOfRecords = formats.any { pieces.beginning(it.signatureSize, it::matches) }
        val end = if (untilLastLineEnd && !isOfRecords) pieces.lastLineEnd() else pieces.total
        val until = if (untilLastLineEnd && !isOfRecords) end else Long.MAX_VALUE
        when {
            pieces.beginning(GzipReader.SIGNATURE_SIZE, GzipReader::isGzip) -> readGzip(pieces, threads(pieces.inflatedSize()))

            isOfRecords || end < MIN_PARALLEL -> {
                val parser =
                    RecordingParser(formats, keepSamples) { BagParser(end, keepSamples, sinks) }
                val recording = readPlain(pieces, until, parser)
                if (untilLastLineEnd) recording.without(ProblemKind.RECORD_CUT) else recording
            }

            else -> {
                val lines = if (keepSamples) reading(file) { countLines(channel, end) } else 0
                ParsingThreads(formats, end, keepSamples, sinks = sinks, expectedLines = lines).use { parsing ->
                    pieces.forEach(until, parsing::accept)
                    parsing.finish()
                }
            }
        }
    }
}

/** Smaller files are read before Java has translated for each of several threads what one needs. */
private const val MIN_PARALLEL = 64L shl 20

private fun readPlain(pieces: FilePieces, until: Long, parser: RecordingParser): Recording {
    pieces.forEach(until) { bytes, size -> parser.accept(bytes, 0, size) }
    return parser.finish()
}

private fun Recording.without(kind: ProblemKind) = copy(problems = problems.filter { it.kind != kind })

private fun readGzip(pieces: FilePieces, threads: ParsingThreads): Recording = threads.use { parsing ->
    GzipReader(parsing::accept).use { reader ->
        pieces.forEach { bytes, size -> reader.accept(bytes, 0, size) }
        val recording = parsing.finish()
        if (reader.isCut) recording.withGzipCut(reader.inflatedBytes) else recording
    }
}
