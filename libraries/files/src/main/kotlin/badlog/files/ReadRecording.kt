package badlog.files

import badlog.core.bag.BagParser
import badlog.core.bag.RecordingParser
import badlog.core.recording.LogFormat
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path

/**
 * Reads [file]: a bag, a CSV file or a log of one of [formats]. It may be compressed with gzip, or [contain a WPILOG][unpacked]. The
 * content determines the format, the name hardly ever. The other [parts][partsOfLog] of the log are read with it. Anything wrong in it
 * becomes a problem of the recording.
 *
 * Besides the recording, it holds pieces of the file in memory, never the whole file: less than 1 MB on the calling thread, which always
 * reads small files and logs of records; otherwise 5 pieces of 256 kB and one more per [core][ReadOptions.cores], and the numbers read
 * from them, which take up to four times as much if they have one digit. A longer row takes twice its length. A column that outgrows its
 * memory is copied, so that it briefly exists twice.
 *
 * @param formats the formats to recognize besides bag and CSV.
 * @param progress called on the calling thread, about once per megabyte, with the number of bytes read and the size of the file at the
 *   start. An exception from it stops the reading and is passed on.
 * @throws UnreadableFileException if the file is missing, is not a regular file, or cannot be read.
 * @throws UnwritableFileException if the temporary WPILOG cannot be written, such as on a full disk.
 * @throws InterruptedException if the thread was interrupted.
 */
public fun readRecording(
    file: Path,
    formats: List<LogFormat>,
    options: ReadOptions = ReadOptions(),
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): Recording {
    requireRegularFile(file)
    return withinMemory(file) {
        unpacked(file, { progress(0, Files.size(file)) }, options.name ?: file.fileName.toString(), options.maker) { log ->
            val recording = read(log.path, formats, options, progress)
            recording.copy(format = log.format ?: recording.format, problems = log.problems + recording.problems)
        }
    }
}

private fun withinMemory(file: Path, read: () -> Recording): Recording = try {
    read()
} catch (e: OutOfMemoryError) {
    throw TooLargeFileException(file, tooLargeSentence("$file"), e)
}

private fun read(
    file: Path,
    formats: List<LogFormat>,
    options: ReadOptions,
    progress: (doneBytes: Long, totalBytes: Long) -> Unit,
): Recording = reading(file) { FileChannel.open(file) }.use { channel ->
    val pieces = FilePieces(file, channel, progress)
    val isGzip = pieces.beginning(GzipReader.SIGNATURE_SIZE, GzipReader::isGzip)
    val isOfRecords = formats.any { pieces.beginning(it.signatureSize, it::matches) }
    val end = if (options.untilLastLineEnd && !isGzip && !isOfRecords) pieces.lastLineEnd() else null
    val until = end ?: Long.MAX_VALUE
    val expectedBytes = if (isGzip) pieces.inflatedSize() else end ?: pieces.total
    val isLarge = if (isGzip) {
        maxOf(expectedBytes, pieces.total * GZIP_GROWTH) >= MIN_PARALLEL_GZIP
    } else {
        !isOfRecords && expectedBytes >= MIN_PARALLEL
    }
    val lines = if (isLarge && !isGzip && options.keepSamples) reading(file) { countLines(channel, expectedBytes, options.cores) } else 0L
    val recording = if (isLarge && options.cores > 1) {
        ParsingThreads(formats, expectedBytes, options, lines).use { parsing ->
            val isFull = { parsing.isFull }
            pieces.read(isGzip, until, isFull, parsing::accept) {
                pieces.readOthers(isFull, parsing::accept)
                parsing.finish()
            }
        }
    } else {
        val bagParser = { BagParser(expectedBytes, options.keepSamples, options.sinks, lines) }
        val parser = RecordingParser(formats, options.keepSamples, bagParser).limited()
        val isFull = { parser.isFull }
        val accept = { bytes: ByteArray, size: Int -> parser.accept(bytes, 0, size) }
        pieces.read(isGzip, until, isFull, accept) {
            pieces.readOthers(isFull, accept)
            parser.finish()
        }
    }
    (if (options.untilLastLineEnd && isOfRecords) recording.without(ProblemKind.RECORD_CUT) else recording).withAdvice()
}

/** Returns the same parser, limited to the number of rows or records that the user of the program allows. */
internal fun RecordingParser.limited(): RecordingParser = also { parser ->
    System.getenv(MAX_ROWS)?.toIntOrNull()?.let { parser.maxRows = it }
}

private const val MAX_ROWS = "BADLOG_MAX_ROWS"

/** Smaller files are read before Java has compiled the code for several threads. */
private const val MIN_PARALLEL = 64L shl 20

/** Inflating is worth a separate thread for smaller files already. */
private const val MIN_PARALLEL_GZIP = 1L shl 20

/** The assumed compression ratio of a gzip file, if its end does not show it. */
private const val GZIP_GROWTH = 4

/** Passes the bytes before [until] to [accept], inflated if necessary, until [isFull]. Returns the result of [finish]. */
private fun FilePieces.read(
    isGzip: Boolean,
    until: Long,
    isFull: () -> Boolean,
    accept: (ByteArray, Int) -> Unit,
    finish: () -> Recording,
): Recording {
    if (!isGzip) {
        forEach(until, isFull, accept)
        return finish()
    }
    return GzipReader(accept).use { reader ->
        forEach(enough = isFull) { bytes, size -> reader.accept(bytes, 0, size) }
        val recording = finish()
        if (reader.isCut && !isFull()) recording.withGzipCut(reader.inflatedBytes) else recording
    }
}

/** Passes the bytes of the log's other parts to [accept], inflated if necessary, until [isFull]. */
private fun FilePieces.readOthers(isFull: () -> Boolean, accept: (ByteArray, Int) -> Unit) = partsOfLog(file).drop(1).forEach { part ->
    reading(part) { FileChannel.open(part) }.use { channel ->
        val pieces = FilePieces(part, channel) { _, _ -> progress(total, total) }
        if (pieces.beginning(GzipReader.SIGNATURE_SIZE, GzipReader::isGzip)) {
            GzipReader(accept).use { reader -> pieces.forEach(enough = isFull) { bytes, size -> reader.accept(bytes, 0, size) } }
        } else {
            pieces.forEach(enough = isFull, sink = accept)
        }
    }
}

/** Returns this recording with advice that a page, where no environment variable can be set, does not give. */
private fun Recording.withAdvice() = copy(
    problems = problems.map {
        if (it.kind == ProblemKind.TOO_MANY_ROWS) it.copy(message = "${it.message} Set $MAX_ROWS to read more.") else it
    },
)

private fun Recording.without(kind: ProblemKind) = copy(problems = problems.filter { it.kind != kind })
