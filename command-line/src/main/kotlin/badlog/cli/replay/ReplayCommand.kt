package badlog.cli.replay

import badlog.cli.SubCommand
import badlog.cli.Task
import badlog.cli.analysis.VirtualTopicOption
import badlog.cli.input.position
import badlog.replay.ReplayOptions
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.validate
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo

/** `badlog replay`. */
internal class ReplayCommand :
    SubCommand(
        "replay",
        "Shows a log to dashboards again, in real time.",
        "It is an NT4 server on this computer, as a robot is; Ctrl+C ends it. docs/replay.md tells how dashboards connect.",
        logHelp = "The log.",
    ) {
    private val port by option("--port", metavar = "N").int().restrictTo(0..MOST_PORT).default(ReplayOptions.USUAL_PORT)
        .help("The port; ${ReplayOptions.USUAL_PORT} unless told.")
    private val speed by option("--speed", metavar = "FACTOR").double().default(1.0)
        .help("How fast: 2 is twice as fast as it was.")
        .validate { if (!(it > 0 && it.isFinite())) fail("must be above 0") }
    private val isLooping by option("--loop").flag().help("Begin again at the end.")
    private val from by option("--from", metavar = "X").position().help("Begin there on the x axis, 90 or 1:30.")
    private val to by option("--to", metavar = "X").position().help("End there on the x axis.")
    private val xTopic by option("--x", metavar = "TOPIC").help("Take this topic as x axis, which CSV does not tell.")
    private val virtual by VirtualTopicOption()

    override fun makeTask(): Task {
        val file = paths.singleOrNull() ?: throw UsageError("name one log to replay")
        return ReplayTask(file, port, speed, isLooping, from, to, xTopic, virtual.definitions, isJson)
    }

    private companion object {
        const val MOST_PORT = 65_535
    }
}
