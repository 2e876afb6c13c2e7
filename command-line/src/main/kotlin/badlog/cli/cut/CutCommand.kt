package badlog.cli.cut

import badlog.cli.command.LogCommand
import badlog.cli.command.Task
import badlog.cli.input.position
import badlog.cli.output.OutputOptions
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double

internal class CutCommand :
    LogCommand(
        "cut",
        "Writes a part of each log.",
        "Rows, or the samples of a WPILOG, are kept when they meet all of --from, --to, --enabled and --around that are given. A " +
            "part of a WPILOG begins with the value that each topic held there. A position is a number in the unit of the x " +
            "axis, or 1:32.5 in minutes and seconds. Without --out, the part of match.bag is match.cut.bag.",
    ) {
    private val from by option("--from", metavar = "X").position().help("Drop what comes before this position.")
    private val to by option("--to", metavar = "X").position().help("Drop what comes after this position.")
    private val isEnabled by option("--enabled").flag().help("Keep the time while the robot was enabled.")
    private val margin by option("--margin", metavar = "LENGTH").double()
        .help("With --enabled: extra length at both ends; default: 0.")
    private val event by option("--around", metavar = "TEXT")
        .help("Keep the time around events and states with this text.")
    private val before by option("--before", metavar = "LENGTH").double().help("With --around: length before; default: 5.")
    private val after by option("--after", metavar = "LENGTH").double().help("With --around: length after; default: 5.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis.")
    private val output by OutputOptions()

    override val examples: List<String> = listOf(
        "cut match.bag --from 1:30 --to 98.5",
        "cut match.bag --enabled --margin 2 --out enabled.bag",
        "cut logs --around brownout --before 2 --after 1 --out brownouts/",
    )

    override fun makeTask(): Task {
        if (margin != null && !isEnabled) throw UsageError("--margin belongs to --enabled")
        if ((before ?: after) != null && event == null) throw UsageError("--before and --after belong to --around")
        if (listOfNotNull(margin, before, after).any { !(it >= 0) }) throw UsageError("a length must be 0 or more")
        val choices = buildList {
            if (from != null || to != null) add(RangeChoice(from, to))
            if (isEnabled) add(EnabledChoice(margin ?: 0.0))
            event?.let { add(EventChoice(it, before ?: AROUND, after ?: AROUND)) }
        }
        if (choices.isEmpty()) throw UsageError("say what to keep: --from, --to, --enabled or --around")
        return CutTask(paths, choices, output.plan(paths), xTopic, isJson)
    }
}

private const val AROUND = 5.0
