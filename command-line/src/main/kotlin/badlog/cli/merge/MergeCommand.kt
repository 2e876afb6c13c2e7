package badlog.cli.merge

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.cli.output.OutputPlan
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.path

/** `badlog merge`. */
internal class MergeCommand :
    SubCommand(
        "merge",
        "Makes one log of several of one run.",
        "Logs with the same topics are put one after the other, in the order of x, and rows that several have only once; logs " +
            "with different topics side by side, each with rows of its own. All need the same clock as x axis. What has the " +
            "same name goes into a folder named like its file. With a WPILOG among them, or when the result is one, each topic " +
            "keeps times of its own. All are held in memory at a time.",
    ) {
    private val out by option("-o", "--out", metavar = "FILE").path().required().help("Write here.")
    private val isForced by option("--force").flag().help("Replace the file if it exists, but never a log that is read.")
    private val appends by option("--append").flag().help("Put all one after the other, whatever their topics.")
    private val joins by option("--join").flag().help("Put all side by side, whatever their topics.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis in every log that has rows.")

    override fun makeTask(): Task {
        if (appends && joins) throw UsageError("--append and --join exclude each other")
        val mode = if (appends) {
            MergeMode.APPEND
        } else if (joins) {
            MergeMode.JOIN
        } else {
            MergeMode.BY_TOPICS
        }
        return MergeTask(paths, mode, out, OutputPlan(null, paths, isForced), xTopic, isJson)
    }
}
