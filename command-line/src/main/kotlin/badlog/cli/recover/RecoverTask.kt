package badlog.cli.recover

import badlog.cli.Console
import badlog.cli.ExitCode
import badlog.cli.Failure
import badlog.cli.LogLoop
import badlog.cli.Outcome
import badlog.cli.Task
import badlog.cli.input.LogInput
import badlog.cli.input.readLog
import badlog.cli.output.FileName
import badlog.cli.output.LeftOut
import badlog.cli.output.LogFormat
import badlog.cli.output.OutputPlan
import badlog.cli.output.copyBeginning
import badlog.cli.output.writeLog
import badlog.recording.Recording
import badlog.terminal.Progress
import java.nio.file.Path

/** Writes clean logs from damaged ones. */
internal class RecoverTask(private val paths: List<Path>, private val plan: OutputPlan, private val isJson: Boolean) : Task {
    override fun run(console: Console): ExitCode = LogLoop("recover", console, isJson).run(paths, ::recover)

    private fun recover(input: LogInput, progress: Progress): Outcome {
        val recording = readLog(input.file, progress)
        val losses = Losses(recording)
        if (!plan.isGiven && !losses.isDamaged) return losses.outcome(input.file, target = null, LeftOut())
        if (recording.topics.isEmpty() || (losses.isDamaged && recording.sampleCount == 0L)) {
            val reason = recording.problems.firstOrNull()?.message.orEmpty()
            throw Failure("${input.file}: nothing can be recovered. $reason".trim())
        }
        val target = plan.place(input, FileName.of(input.file).marked("recovered"), input.file.fileName.toString())
        val leftOut = write(input.file, recording, losses, target, progress)
        requireSame(recording, target)
        return losses.outcome(input.file, target, leftOut)
    }

    private fun write(file: Path, recording: Recording, losses: Losses, target: Path, progress: Progress): LeftOut {
        val format = LogFormat.of(recording)
        val lostBytes = losses.bytesAtEnd
        if (format.hasRows || lostBytes == null) return writeLog(recording, format, target, progress = progress)
        // A WPILOG of our own has the fields of structs, not the structs.
        copyBeginning(file, lostBytes, target, progress)
        return LeftOut()
    }
}
