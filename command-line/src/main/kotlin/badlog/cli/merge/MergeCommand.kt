package badlog.cli.merge

import badlog.cli.command.LogCommand
import badlog.cli.command.Task
import badlog.cli.output.OutputPlan
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.path

internal class MergeCommand :
    LogCommand(
        "merge",
        "Merges several logs of one run into one.",
        "Logs with the same topics are appended in order of x, or as given without x; duplicate rows are kept once. Logs with " +
            "different topics are joined side by side, each with its own rows. All need the same clock as x axis. A topic whose " +
            "name is taken goes into a folder named after its file. With a WPILOG among the logs, or as the result, each topic " +
            "keeps its own times. All logs are held in memory at once. Logs of other clocks need --offset or --align; " +
            "--with-ds finds one. A name that ends in .zip makes a ZIP of " +
            "the logs as they are, with their clocks in match.json; --with-ds then also finds logs of motors and CAN buses nearby.",
    ) {
    private val out by option("-o", "--out", metavar = "FILE").path().required().help("Write to this file.")
    private val isForced by option("--force").flag().help("Replace an existing file, but never a log that is read.")
    private val appends by option("--append").flag().help("Append all logs, whatever their topics.")
    private val joins by option("--join").flag().help("Join all logs side by side, whatever their topics.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis in every log that has rows.")
    private val match by MatchOptions()

    override val examples: List<String> = listOf(
        "merge first.bag second.bag --out match.bag",
        "merge match.bag vision.wpilog --align enabled --out all.wpilog",
        "merge match.bag --with-ds=ds-logs --out all.wpilog",
        "merge match.bag rev.revlog --with-ds=ds-logs --out match.zip",
    )

    override fun makeTask(): Task {
        if (appends && joins) throw UsageError("--append and --join cannot be used together")
        if (isZip(out) && (appends || joins || xTopic != null)) {
            throw UsageError("a ZIP has the logs as they are, so --append, --join and --x cannot be used with it")
        }
        val mode = if (appends) {
            MergeMode.APPEND
        } else if (joins) {
            MergeMode.JOIN
        } else {
            MergeMode.BY_TOPICS
        }
        val plan = OutputPlan(null, paths, isForced, station = match.station)
        return MergeTask(paths, match.merging(paths, mode, acceptsOnly = true), out, plan, xTopic, isJson)
    }
}
