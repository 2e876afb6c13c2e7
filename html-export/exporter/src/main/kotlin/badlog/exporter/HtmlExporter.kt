package badlog.exporter

import badlog.core.bag.RecordingParser
import badlog.exporter.NotesFile
import badlog.files.AtomicFile
import badlog.files.LogMaker
import badlog.files.ReadOptions
import badlog.files.Unpacked
import badlog.files.partsOfLog
import badlog.files.readRecording
import badlog.files.terminal.Progress
import badlog.files.unpacked
import badlog.files.withGzipCut
import badlog.formats.LOG_FORMATS
import badlog.protocol.PageAdditions
import java.io.ByteArrayInputStream
import java.io.InputStream
import java.io.SequenceInputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/**
 * Exports recordings as self-contained HTML pages. Each page contains the file's exact bytes, and the program that shows them. It uses all
 * cores, and memory that does not grow with the file. One exporter can make any number of pages, also concurrently.
 *
 * @param attachments files to put into every page beside the recording.
 * @param compared logs that every page draws over its own; a page's own log is skipped.
 * @param parts the program and the styles of the pages.
 * @param maker merges the logs in a file that contains several; null if such files are not exported.
 */
class HtmlExporter(
    private val attachments: List<Path> = emptyList(),
    private val compared: List<Path> = emptyList(),
    private val parts: PageParts = PageParts.bundled(),
    private val maker: LogMaker? = null,
) {
    /** The compared logs that have been checked to be logs. */
    private val readable = ConcurrentHashMap.newKeySet<Path>()

    /**
     * Makes the page [output] from the log [input]. The log is a bag, a CSV file, a WPILOG or a Driver Station log, optionally compressed
     * with gzip. If a log has two files, the page contains both. Problems are listed in the report and on the page. [output] is replaced
     * only by a complete page; its folder is created if necessary.
     *
     * To cancel, interrupt the calling thread or throw from [progress].
     *
     * @param additions the content of the page besides the recording and the notes in the files beside [input].
     * @throws ExportException if there is nothing to show, or a file cannot be read or written.
     * @throws InterruptedException if the thread was interrupted.
     */
    fun export(
        input: Path,
        output: Path,
        additions: PageAdditions = PageAdditions(),
        progress: Progress = Progress { _, _ -> },
    ): ExportReport {
        val page = output.toAbsolutePath().normalize()
        val logParts = partsOfLog(input)
        val files = attachments + compared + logParts
        files.forEach(::checkReadable)
        checkWritable(page, files)
        return refusing {
            unpacked(input, { progress.advanced(0, Files.size(input)) }, maker = maker) { log ->
                val exported = ExportedLog(input, log, if (log.path == input) logParts else listOf(log.path))
                export(exported, page, withNotes(additions, input), progress)
            }
        }
    }

    /** The log in [input], with the same content as the files [parts]. */
    private class ExportedLog(val input: Path, val log: Unpacked, val parts: List<Path>)

    private fun export(exported: ExportedLog, page: Path, additions: PageAdditions, progress: Progress): ExportReport {
        val input = exported.input
        return reading(input) { Files.newInputStream(exported.log.path) }.use { stream ->
            val first = reading(input) { stream.readNBytes(FileHead.BYTES) }
            val head = FileHead.of(first)
            if (head.refusal != null) throw ExportException.NotARecording(input, head.refusal)
            val source = ReadGuard(input, SequenceInputStream(ByteArrayInputStream(first), stream))
            withOthers(source, exported.parts).use { whole ->
                passingOn(progress) { reported -> writing(page) { write(exported, whole, head, page, additions, reported) } }
            }
        }
    }

    /** Returns [first], the bytes of the first of [logParts], followed by the bytes of the others. */
    private fun withOthers(first: InputStream, logParts: List<Path>): InputStream = logParts.drop(1).fold(first) { before, part ->
        SequenceInputStream(before, ReadGuard(part, reading(part) { Files.newInputStream(part) }))
    }

    private fun withNotes(additions: PageAdditions, log: Path): PageAdditions {
        val read = NotesFile.read(log)
        if (read.history.isEmpty && read.problems.isEmpty()) return additions
        return additions.withNotes(read.history, read.problems.joinToString(" ").ifEmpty { null })
    }

    private fun write(
        exported: ExportedLog,
        source: InputStream,
        head: FileHead,
        page: Path,
        additions: PageAdditions,
        progress: Progress,
    ): ExportReport {
        val input = exported.input
        val logParts = exported.parts
        val name = exported.log.name
        val firstBytes = Files.size(exported.log.path)
        val total = logParts.sumOf(Files::size)
        val parser = RecordingParser(LOG_FORMATS, keepSamples = false)
        Files.createDirectories(page.parent)
        return AtomicFile(page).use { file ->
            val writer = PageWriter(file.out, parts)
            val signals = additions.rules.signals
            val heads = sequenceOf(head) + logParts.asSequence().drop(1).map(::headOf)
            // A file's name may belong to another match. It decides only if no part of the log identifies the match.
            val identifying = heads.firstOrNull { it.identifiesMatch(signals) } ?: head
            writer.begin(identifying.titleIn(name, signals) ?: name, additions.video != null)
            writer.program(additions)
            val embedded = ExportThreads().use { threads ->
                // Only a large file is worth several workers, and reading while the page is still loading.
                val lineBytes = total.takeIf { head.hasLines && !head.isGzip && it > MANY_BYTES }
                val embedded = writer.recording(name, lineBytes) { out ->
                    val reported: (Long) -> Unit = { progress.advanced(it, total) }
                    if (head.isGzip) {
                        GzipEmbedding(threads, out, parser::accept).embed(source, reported)
                    } else {
                        RawEmbedding(threads, out, parser::accept).embed(source, reported)
                    }
                }
                attachments.forEach { file -> embed(file, threads) { writer.attachment(file.fileName.toString(), it) } }
                compared.filterNot { Files.isSameFile(it, input) }.forEach { compare(it, writer, threads) }
                embedded
            }
            val embeddedFile = embedded.file
            val parsed = parser.finish()
            val read = if (embeddedFile.isCut) parsed.withGzipCut(embeddedFile.inflatedBytes) else parsed
            val recording = read.copy(problems = exported.log.problems + read.problems)
            recording.refusal?.let { throw ExportException.NotARecording(input, it) }
            writer.end(name, embedded, head.isGzip, logParts.getOrNull(1)?.let { SecondPart(it.fileName.toString(), firstBytes) })
            file.commit()
            ExportReport(page, recording, embeddedFile.originalBytes, embeddedFile.inflatedBytes)
        }
    }

    private fun headOf(file: Path): FileHead =
        FileHead.of(reading(file) { Files.newInputStream(file).use { it.readNBytes(FileHead.BYTES) } })

    private fun compare(input: Path, writer: PageWriter, threads: ExportThreads) = unpacked(input, {}, maker = maker) { log ->
        // All pages of a folder compare with the same logs.
        if (input !in readable) {
            val compared = readRecording(log.path, LOG_FORMATS, ReadOptions(keepSamples = false))
            compared.refusal?.let { throw ExportException.NotARecording(input, it) }
            readable.add(input)
        }
        val parts = if (log.path == input) partsOfLog(input) else listOf(log.path)
        parts.forEachIndexed { i, part ->
            val name = if (i == 0) log.name else part.fileName.toString()
            embed(part, threads) { writer.compared(name, it) }
        }
    }

    private fun embed(file: Path, threads: ExportThreads, write: ((Base64Stream) -> EmbeddedFile) -> Unit) =
        reading(file) { Files.newInputStream(file) }.use { stream -> write { RawEmbedding(threads, it).embed(ReadGuard(file, stream)) } }
}

private const val MANY_BYTES = 4_000_000L
