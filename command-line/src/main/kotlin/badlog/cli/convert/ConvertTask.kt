package badlog.cli.convert

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.LogInput
import badlog.cli.output.Omissions
import badlog.cli.output.OutputPlan
import badlog.cli.output.changesOf
import badlog.cli.output.copyBeginning
import badlog.cli.output.copyRecords
import badlog.cli.output.isEvent
import badlog.cli.output.newLog
import badlog.cli.output.recordsOf
import badlog.cli.output.writeLog
import badlog.cli.recover.Damage
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.lossLines
import badlog.cli.text.undefinedLines
import badlog.cli.text.wrapped
import badlog.cli.topic.TopicChoice
import badlog.core.analysis.resampled
import badlog.core.recording.Recording
import badlog.files.terminal.Progress
import badlog.formats.wpilog.Omission
import badlog.formats.wpilog.record.MergedEntry
import badlog.formats.wpilog.record.RecordEntry
import badlog.formats.wpilog.record.RecordMerge
import badlog.formats.wpilog.record.RecordPiece
import badlog.report.UndefinedJson
import badlog.report.withX
import kotlinx.serialization.Serializable
import java.nio.file.Path

/**
 * Writes logs in another format.
 *
 * @param virtualTopics definitions of topics to add.
 * @param only the topics to write.
 */
internal class ConvertTask(
    private val paths: List<Path>,
    private val plan: OutputPlan,
    private val conversion: LogConversion,
    private val virtualTopics: List<String>,
    private val only: TopicChoice,
    private val isJson: Boolean,
) : Task {
    private class WithRows(val recording: Recording, val leftOut: Omissions)

    override fun run(console: Console): ExitCode = LogLoop("convert", console, isJson, opensMatches = true).run(paths, ::convert)

    private fun convert(input: LogInput, progress: Progress): Outcome {
        val log = LogToConvert(input, virtualTopics, only, needed = listOfNotNull(conversion.xTopic, conversion.rows.topic), progress)
        val fit = if (conversion.format.hasRows) withRows(log.wanted, input.file) else WithRows(log.wanted, Omissions())
        val recording = fit.recording
        val converted = log.name.with(conversion.format.ending, conversion.isGzip || log.name.isGzip)
        val target = plan.place(input, converted, converted)
        val calculated = recording.copy(values = emptyList(), topics = recording.topics.filter { it.name in log.added })
        val leftOut = fit.leftOut + write(input.file, log.isMatch, recording, calculated, target, progress)
        val count = if (conversion.format.hasRows) {
            counted(recording.rowCount.toLong(), "row")
        } else {
            "${counted(recording.sampleCount, "sample")} of ${counted(recording.topics.size.toLong(), "topic")}"
        }
        val text = listOf("${input.file} -> $target", wrapped("  ", count + leftOut.tail, INDENT)) + leftOut.lines +
            undefinedLines(log.all.errors) +
            lossLines(recording.problems)
        val json = ConvertJson(
            target.toString(),
            conversion.format.option,
            recording.rowCount,
            recording.sampleCount,
            leftOut.all,
            log.all.errors.map(::UndefinedJson),
        )
        return Outcome(recording.isSalvaged || leftOut.hasLoss, text.joinToString("\n"), jsonOf(json))
    }

    private fun write(
        file: Path,
        isMatch: Boolean,
        recording: Recording,
        calculated: Recording,
        target: Path,
        progress: Progress,
    ): Omissions {
        if (isMatch || !recording.format.hasRecords || conversion.format.hasRows) {
            return writeLog(recording, conversion.format, target, changesOnly = conversion.isChangesOnly, progress = progress)
        }
        val lostBytes = Damage(recording).bytesAtEnd
        val isWhole = !conversion.isChangesOnly && virtualTopics.isEmpty() && only.isAll
        if (isWhole && lostBytes != null) {
            copyBeginning(file, lostBytes, target, progress)
            return Omissions()
        }
        val records = recordsOf(file)
        if (virtualTopics.isEmpty() && only.isAll) {
            if (conversion.isChangesOnly) return omissionOf(copyRecords(records, target, progress) { changes(recording::isEvent) })
            copyRecords(records, target, progress) { all() }
            return Omissions()
        }
        val kept = if (conversion.isChangesOnly) changesOf(records, recording::isEvent) else records
        val repeats = records.entries.sumOf { it.size } - kept.entries.sumOf { it.size }
        val wanted = kept.entries.filter { it.isWanted(recording) }
        return omissionOf(repeats) + writeWith(calculated, wanted, target, progress)
    }

    /**
     * Returns whether to keep this entry: the topics of [recording], values, schemas, and everything if no topics are selected. The names of a
     * struct's fields begin with the entry's name.
     */
    private fun RecordEntry.isWanted(recording: Recording) = only.isAll || isValue || SCHEMAS in "/$name" ||
        recording.topics.any { it.name == name || it.name.startsWith("$name/") || it.name.startsWith("$name (") }

    /** Writes [records] and [calculated], the topics that were not logged. */
    private fun writeWith(calculated: Recording, records: List<RecordEntry>, target: Path, progress: Progress): Omissions {
        val (more, leftOut) = recordsOf(calculated, conversion.isChangesOnly)
        val lanes = (records + more.entries).map { MergedEntry(it.name, listOf(RecordPiece(it))) }
        newLog(target) { stream -> RecordMerge(lanes).write(progress::advanced) { bytes, size -> stream.write(bytes, 0, size) } }
        return leftOut
    }

    private fun omissionOf(repeats: Int): Omissions =
        Omissions(omissions = if (repeats == 0) emptyList() else listOf(Omission(null, REPEATS, repeats)))

    private fun withRows(read: Recording, file: Path): WithRows {
        val hasRows = read.format.hasRows
        val times = if (hasRows) null else conversion.rows.timesIn(read, file)
        val recording = if (times == null) withRowsOnly(read) else resampled(read, times)
        val leftOut = if (times == null) {
            Omissions(listOfNotNull(Omissions.thing(read.topics.size - recording.topics.size, "calculated topic")))
        } else {
            rowOmissions(read, times)
        }
        return WithRows(if (conversion.xTopic == null) recording else recording.withX(conversion.xTopic, file), leftOut)
    }

    /** Without calculated topics that have no value in each row. */
    private fun withRowsOnly(read: Recording): Recording {
        val columns = read.topics.filter { it.times == null && it.size == read.rowCount }
        if (columns.size == read.topics.size) return read
        return read.copy(topics = columns)
    }
}

@Serializable
private class ConvertJson(
    private val output: String,
    private val format: String,
    private val rows: Int,
    private val samples: Long,
    private val leftOut: List<String>,
    private val undefined: List<UndefinedJson>,
)

private const val INDENT = 4

/** The part of an entry's name that marks a type description, which other entries need. */
private const val SCHEMAS = "/.schema/"
private const val REPEATS = "Samples that repeat the previous one have no record."
