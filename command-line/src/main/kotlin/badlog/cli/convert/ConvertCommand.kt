package badlog.cli.convert

import badlog.cli.command.LogCommand
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.input.LogSearch
import badlog.cli.output.OutputFormat
import badlog.cli.output.OutputOptions
import badlog.cli.plugin.PluginLoader
import badlog.cli.topic.OnlyOption
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.double

internal class ConvertCommand(private val parts: PluginLoader) :
    LogCommand(
        "convert",
        "Writes logs in another format.",
        "Every number is kept to its last bit; what the format cannot hold is listed. A WPILOG has no rows: a bag or CSV " +
            "made from it has the last value of each topic in each row. docs/season.md describes the columns of Parquet files. Without " +
            "--out, match.bag becomes match.csv beside it. A file whose name ends in .gz is compressed.",
    ) {
    private val to by option("--to").choice(*OPTIONS.toTypedArray(), metavar = "FORMAT")
        .help("${OPTIONS.joinToString()}; default: from the --out name.")
    private val output by OutputOptions()
    private val isGzip by option("-z", "--gzip").flag().help("Compress the results, and add .gz to their names.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Make this topic the x axis of the bag.")
    private val period by option("--period", metavar = "SECONDS").double()
        .help("Seconds between the rows of a WPILOG; default: ${Rows.DEFAULT_PERIOD}.")
        .validate { if (!(it > 0 && it.isFinite())) fail("must be above 0") }
    private val rowsAt by option("--rows-at", metavar = "TOPIC")
        .help("Make the rows of a WPILOG at this topic's times.")
    private val isChangesOnly by option("--changes-only")
        .flag().help("Leave repeated samples out of a WPILOG.")
    private val virtual by VirtualTopicOption()
    private val only by OnlyOption()

    override val examples: List<String> = listOf(
        "convert match.bag --to csv",
        "convert match.wpilog --out match.bag --period 0.01",
        "convert logs --to wpilog --only \"PDP/*\" --out converted/",
    )

    override fun makeTask(): Task {
        if (period != null && rowsAt != null) throw UsageError("--period and --rows-at cannot be used together")
        if (isParquet()) return parquetTask()
        val format = OutputFormat.entries.find { it.option == to } ?: output.outPath?.let(OutputFormat::ofName)
            ?: throw UsageError("name the format: ${OPTIONS.joinToString(" or ") { "--to $it" }}")
        if (!format.hasRows && (period != null || rowsAt != null)) {
            throw UsageError("--period and --rows-at belong to --to bag and --to csv; a WPILOG has no rows")
        }
        if (!format.hasRows && xTopic != null) throw UsageError("--x belongs to --to bag and --to csv; a WPILOG's x is time")
        if (format.hasRows && isChangesOnly) throw UsageError("--changes-only belongs to --to wpilog; each row has all topics")
        val conversion = LogConversion(format, isGzip, xTopic, Rows(period, rowsAt), isChangesOnly)
        return ConvertTask(paths, plan(), conversion, virtual.definitions, only.choice, isJson)
    }

    /** A folder that is one match is one log. */
    private fun plan() = output.plan(paths, isOne = LogSearch(opensMatches = true).find(paths).inputs.singleOrNull()?.isFound == false)

    private fun isParquet() =
        to == ParquetTask.OPTION || (to == null && output.outPath.toString().endsWith(ParquetTask.ENDING, ignoreCase = true))

    private fun parquetTask(): Task {
        val others = listOf("--gzip" to isGzip, "--x" to (xTopic != null), "--period" to (period != null), "--rows-at" to (rowsAt != null))
        (others + ("--changes-only" to isChangesOnly)).firstOrNull { it.second }?.let { (option, _) ->
            throw UsageError("$option has no effect on Parquet files; leave it out")
        }
        return ParquetTask(paths, plan(), virtual.definitions, only.choice, parts, isJson)
    }

    private companion object {
        val OPTIONS = OutputFormat.entries.map { it.option } + ParquetTask.OPTION
    }
}
