package badlog.file

import badlog.bag.BagParser
import badlog.bag.FileSignature
import badlog.recording.Recording
import java.nio.channels.FileChannel
import java.nio.file.Path

/**
 * Reads [file]: a bag or a CSV file, perhaps compressed with gzip; its content decides, never its name. Whatever is wrong
 * in it becomes a problem of the recording. Besides the recording, it holds less than 3 MB whatever the file's size.
 *
 * @param keepSamples false to find only topics, counts and problems, in memory that does not grow with the file.
 * @param untilLastLineEnd true to leave out what stands after the file's last line end, or all where there is none: the
 *   half of a row in a file that is still being written, and no problem. Without effect on a compressed file.
 * @param progress hears, on the calling thread and about once a megabyte, how many bytes of the file are read and how many
 *   it had at the beginning. What it throws stops the reading and is passed on.
 * @throws UnreadableFileException when the file is missing, is no regular file, or cannot be read.
 * @throws InterruptedException when the thread was interrupted.
 */
public fun readRecording(
    file: Path,
    keepSamples: Boolean = true,
    untilLastLineEnd: Boolean = false,
    progress: (doneBytes: Long, totalBytes: Long) -> Unit = { _, _ -> },
): Recording {
    requireRegularFile(file)
    return reading(file) { FileChannel.open(file) }.use { channel ->
        val pieces = FilePieces(file, channel, progress)
        if (pieces.signature() == FileSignature.GZIP) {
            readGzip(pieces, BagParser(pieces.inflatedSize(), keepSamples))
        } else {
            val end = if (untilLastLineEnd) pieces.lastLineEnd() else pieces.total
            val parser = BagParser(end, keepSamples)
            pieces.forEach(if (untilLastLineEnd) end else Long.MAX_VALUE) { bytes, size -> parser.accept(bytes, 0, size) }
            parser.finish()
        }
    }
}

private fun readGzip(pieces: FilePieces, parser: BagParser): Recording = ParsingThread(parser).use { parsing ->
    GzipReader(parsing::accept).use { reader ->
        pieces.forEach { bytes, size -> reader.accept(bytes, 0, size) }
        val recording = parsing.finish()
        if (reader.isCut) recording.withGzipCut(reader.inflatedBytes) else recording
    }
}
