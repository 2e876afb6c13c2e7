package badlog.files

import badlog.core.bag.BagParser
import badlog.core.bag.RecordingParser
import badlog.core.recording.LogFormat
import badlog.core.recording.NumberSinks
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path

/**
 * Reads [file]: a bag, a CSV file or a log of one of [formats], optionally compressed with gzip, or [containing a WPILOG][unpacked]; its
 * content decides, hardly ever its name. The other [parts][partsOfLog] of the log are read with it. Whatever is wrong in it becomes a
 * problem of the recording.
 *
 * Besides the recording, it holds pieces of the file in memory, never the whole file: less than 1 MB on the calling thread, which always
 * reads small files and logs of records; otherwise [cores] + 5 pieces of 256 kB, and the numbers read from them, which take up to four
 * times as much if they have one digit. A longer row takes twice its length. A column that outgrows its memory is copied, so that it
 * briefly exists twice.
 *
 * @param formats the formats to recognize besides bag and CSV.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param untilLastLineEnd true to ignore everything after the file's last line end, or everything if there is none: part of a row in a file
 *   that is still being written is not a problem. The same applies to part of a record at the end of a log of records. Has no effect on a
 *   compressed file.
 * @param sinks where numbers of a bag's or CSV file's topics go that the recording is not to keep; texts and counts are kept all the same.
 *   It and its sinks are called on one thread at a time, though not always the same one, and not the calling one; all calls have returned
 *   when this function returns. Each sink receives each row once, in order. Not used for logs of records.
 * @param cores the number of cores for reading a large file; 1 for only the calling thread, if others read other files meanwhile.
 * @param name the name of the log, if the file temporarily has another one.
 * @param progress called on the calling thread, about once per megabyte, with the number of bytes read and the size of the file at the
 *   start. An exception from it stops the reading and is passed on.
 * @throws UnreadableFileException if the file is missing, is not a regular file, or cannot be read.
 * @throws UnwritableFileException if the temporary WPILOG cannot be written, such as on a full disk.
 * @throws InterruptedException if the thread was interrupted.
 */
public fun readRecording(
    file: Path,
    formats: List<LogFormat>,
    keepSamples: Boolean = true,
    untilLastLineEnd: Boolean = false,
    sinks: NumberSinks = NumberSinks.RECORDING,
    cores: Int = Runtime.getRuntime().availableProcessors(),
    name: String = file.fileName.toString(),
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): Recording {
    requireRegularFile(file)
    return withinMemory(file) {
        unpacked(file, { progress(0, Files.size(file)) }, name) { log ->
            val recording = read(log.path, formats, keepSamples, untilLastLineEnd, sinks, cores, progress)
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
    keepSamples: Boolean,
    untilLastLineEnd: Boolean,
    sinks: NumberSinks,
    cores: Int,
    progress: (doneBytes: Long, totalBytes: Long) -> Unit,
): Recording = reading(file) { FileChannel.open(file) }.use { channel ->
    val pieces = FilePieces(file, channel, progress)
    val isGzip = pieces.beginning(GzipReader.SIGNATURE_SIZE, GzipReader::isGzip)
    val isOfRecords = formats.any { pieces.beginning(it.signatureSize, it::matches) }
    val end = if (untilLastLineEnd && !isGzip && !isOfRecords) pieces.lastLineEnd() else null
    val until = end ?: Long.MAX_VALUE
    val expectedBytes = if (isGzip) pieces.inflatedSize() else end ?: pieces.total
    val isLarge = if (isGzip) {
        maxOf(expectedBytes, pieces.total * GZIP_GROWTH) >= MIN_PARALLEL_GZIP
    } else {
        !isOfRecords && expectedBytes >= MIN_PARALLEL
    }
    val lines = if (isLarge && !isGzip && keepSamples) reading(file) { countLines(channel, expectedBytes, cores) } else 0L
    val recording = if (isLarge && cores > 1) {
        ParsingThreads(formats, expectedBytes, keepSamples, sinks, cores, lines).use { parsing ->
            val isFull = { parsing.isFull }
            pieces.read(isGzip, until, isFull, parsing::accept) {
                pieces.readOthers(isFull, parsing::accept)
                parsing.finish()
            }
        }
    } else {
        val parser = RecordingParser(formats, keepSamples) { BagParser(expectedBytes, keepSamples, sinks, lines) }.limited()
        val isFull = { parser.isFull }
        val accept = { bytes: ByteArray, size: Int -> parser.accept(bytes, 0, size) }
        pieces.read(isGzip, until, isFull, accept) {
            pieces.readOthers(isFull, accept)
            parser.finish()
        }
    }
    if (untilLastLineEnd && isOfRecords) recording.without(ProblemKind.RECORD_CUT) else recording
}

/** Returns the same parser, limited to the number of rows or records that the user of the program allows. */
internal fun RecordingParser.limited(): RecordingParser = also { parser ->
    System.getenv("BADLOG_MAX_ROWS")?.toIntOrNull()?.let { parser.maxRows = it }
}

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

private fun Recording.without(kind: ProblemKind) = copy(problems = problems.filter { it.kind != kind })
