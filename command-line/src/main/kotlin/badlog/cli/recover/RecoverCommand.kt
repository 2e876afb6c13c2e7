package badlog.cli.recover

import badlog.cli.command.ExitCode
import badlog.cli.command.LogCommand
import badlog.cli.command.LogLoop
import badlog.cli.command.Outcome
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.input.Failure
import badlog.cli.input.LogInput
import badlog.cli.input.readLog
import badlog.cli.output.Omissions
import badlog.cli.output.OutputFormat
import badlog.cli.output.OutputOptions
import badlog.cli.output.OutputPlan
import badlog.cli.output.copyBeginning
import badlog.cli.output.copyRecords
import badlog.cli.output.recordsOf
import badlog.cli.output.writeLog
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.files.ReadOptions
import badlog.files.readRecording
import badlog.files.terminal.Progress
import badlog.formats.LOG_FORMATS
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import java.nio.file.Path

internal class RecoverCommand :
    LogCommand(
        "recover",
        "Writes a clean log from a damaged one, and reports what was lost.",
        "Without --out, the clean log of match.bag is match.recovered.bag, and undamaged logs are left alone; with it, they " +
            "are copied too. Each result is read again to verify it.",
    ) {
    private val output by OutputOptions()

    override val examples: List<String> = listOf(
        "recover match.bag",
        "recover logs --out clean/",
    )

    override fun makeTask(): Task = RecoverTask(paths, output.plan(paths), isJson)
}

/** Writes clean logs from damaged ones. */
internal class RecoverTask(private val paths: List<Path>, private val plan: OutputPlan, private val isJson: Boolean) : Task {
    override fun run(console: Console): ExitCode = LogLoop("recover", console, isJson).run(paths, ::recover)

    private fun recover(input: LogInput, progress: Progress): Outcome {
        val recording = readLog(input.file, progress)
        val damage = Damage(recording)
        if (!plan.isGiven && !damage.isDamaged) return damage.outcome(input.file, target = null, Omissions())
        if (recording.topics.isEmpty() || (damage.isDamaged && recording.sampleCount == 0L)) {
            val reason = recording.problems.firstOrNull()?.message.orEmpty()
            throw Failure("${input.file}: nothing can be recovered. $reason".trim())
        }
        val name = OutputFormat.nameFor(input.file, recording)
        val target = plan.place(input, name.marked("recovered"), name.toString())
        val leftOut = write(input.file, recording, damage, target, progress)
        requireSame(recording, target)
        return damage.outcome(input.file, target, leftOut)
    }

    private fun write(file: Path, recording: Recording, damage: Damage, target: Path, progress: Progress): Omissions {
        val format = OutputFormat.of(recording)
        val lostBytes = damage.bytesAtEnd
        if (!recording.format.hasRecords) return writeLog(recording, format, target, progress = progress)
        if (lostBytes != null) {
            copyBeginning(file, lostBytes, target, progress)
        } else {
            copyRecords(recordsOf(file), target, progress) { all() }
        }
        return Omissions()
    }
}

/**
 * Reads [written] again, which was made from [recording], and checks that it is complete and has the same content.
 *
 * @throws Failure if it is not.
 */
internal fun requireSame(recording: Recording, written: Path) {
    val again = readRecording(written, LOG_FORMATS, ReadOptions(keepSamples = false))
    val hasAll = again.rowCount == recording.rowCount && again.topics.map(::contentOf) == recording.topics.map(::contentOf)
    if (again.isSalvaged || !hasAll) {
        throw Failure(
            "$written was written, but reads differently: a text in it looks like rows, or a name " +
                "does not fit in the title line; compare it with badlog info.",
        )
    }
}

/** Returns the content of its cells, regardless of how they are written. */
private fun contentOf(topic: Topic): List<Any> {
    val counts = topic.counts
    return listOf(topic.name, counts.numbers + counts.truthValues, counts.texts)
}
