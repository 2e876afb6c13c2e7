package badlog.cli.convert

import badlog.cli.SubCommand
import badlog.cli.Task
import badlog.cli.output.LogFormat
import badlog.cli.output.OutputOptions
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.double

/** `badlog convert`. */
internal class ConvertCommand : SubCommand(
    "convert",
    "Writes logs in another format.",
    "Every number is kept to its last bit; what the format has no place for is listed. Without --out, match.csv stands " +
        "beside match.bag. A name that ends in .gz is compressed.",
) {
    private val to by option("--to").choice(LogFormat.entries.associateBy { it.option })
        .help("The format, unless the name after --out tells it.")
    private val output by OutputOptions()
    private val isGzip by option("-z", "--gzip").flag().help("Compress the results, with .gz at their names.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Make this topic the x axis of the bag.")

    private val period by option("--period", metavar = "SECONDS").double().default(USUAL_PERIOD)
        .help("How far apart a WPILOG's rows are; usually $USUAL_PERIOD.")
        .validate { if (!(it > 0)) fail("must be above 0") }

    override fun makeTask(): Task {
        val format = to ?: output.outPath?.let(LogFormat::ofName)
            ?: throw UsageError("name the format: --to ${LogFormat.entries.joinToString(" or --to ") { it.option }}")
        return ConvertTask(paths, format, output.plan(paths), isGzip, xTopic, period, isJson)
    }

    private companion object {
        /** A robot's loop, in seconds. */
        const val USUAL_PERIOD = 0.02
    }
}
