package badlog.file

import badlog.bag.BagParser
import badlog.bag.RecordingParser
import badlog.recording.LogFormat
import badlog.recording.NumberSinks
import badlog.recording.ProblemKind
import badlog.recording.Recording
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path

/**
 * Reads [file]: a bag, a CSV file or a log of one of [formats], perhaps compressed with gzip, or [holding a WPILOG][unpacked]; its
 * content decides, hardly ever its name. The other [parts][partsOfLog] of the log are read with it. Whatever is wrong in it becomes a problem of the recording.
 *
 * Besides the recording, it holds pieces of the file, never the file: less than 1 MB on the calling thread, where small files and logs
 * of records are always read; else [cores] and five more pieces of 256 kB, and the numbers read from them, which take up to four times
 * as much where they have one digit. A longer row takes twice its length. A column that outgrows its room is copied, so that for a
 * moment it is there twice.
 *
 * @param formats what it may be besides a bag and a CSV file.
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param untilLastLineEnd true to leave out what stands after the file's last line end, or all where there is none: the
 *   half of a row in a file that is still being written, and no problem. So is the half of a record at the end of a log of records.
 *   Without effect on a compressed file.
 * @param sinks where the numbers of a bag's or CSV file's topics go that the recording is not to have; texts and counts are in it
 *   all the same. It is asked, and each of its sinks is called, on one thread at a time, though not always on the same and not on the
 *   calling one; all calls have returned when this one does. Each sink gets each row once, in order. Logs of records have no use for it.
 * @param cores on how many cores a large file is read; 1 for the calling thread alone, where others read other files meanwhile.
 * @param name what the log is called, where the file has another name meanwhile.
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
    cores: Int = Runtime.getRuntime().availableProcessors(),
    name: String = file.fileName.toString(),
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): Recording {
    requireRegularFile(file)
    return withinMemory(file) {
        unpacked(file, { progress(0, Files.size(file)) }, name) { log ->
            val recording = read(log.path, formats, keepSamples, untilLastLineEnd, sinks, cores, progress)
            if (log.problems.isEmpty()) recording else recording.copy(problems = log.problems + recording.problems)
        }
    }
}

private fun withinMemory(file: Path, read: () -> Recording): Recording = try {
    read()
} catch (e: OutOfMemoryError) {
    val megabytes = Runtime.getRuntime().maxMemory() shr 20
    throw UnreadableFileException(
        file,
        "$file does not fit into the $megabytes MB of memory that this program may use; set JAVA_OPTS to a larger -Xmx, such as -Xmx8g.",
        e,
    )
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

/** The same parser, which reads as many rows or records as the person who started the program allows. */
internal fun RecordingParser.limited(): RecordingParser = also { parser ->
    System.getenv("BADLOG_MAX_ROWS")?.toIntOrNull()?.let { parser.maxRows = it }
}

/** Smaller files are read before Java has translated for each of several threads what one needs. */
private const val MIN_PARALLEL = 64L shl 20

/** Inflating is work enough for a thread of its own earlier. */
private const val MIN_PARALLEL_GZIP = 1L shl 20

/** How much more a gzip file holds, where its end does not tell. */
private const val GZIP_GROWTH = 4

/** Gives the bytes before [until] to [accept], inflated where need be, until it [isFull]; returns what [finish] made of them. */
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

/** Gives the bytes of the log's other parts to [accept], inflated where need be, until it [isFull]. */
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
