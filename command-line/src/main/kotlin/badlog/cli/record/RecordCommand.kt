package badlog.cli.record

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.cli.fetch.Robots
import badlog.cli.topic.OnlyOption
import badlog.cli.topic.TopicChoice
import badlog.fetch.NetworkTablesSearch
import badlog.networktables.record.RecordOptions
import badlog.networktables.record.ServerAddress
import badlog.networktables.record.robotServers
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path

internal class RecordCommand(private val robots: Robots) :
    SubCommand(
        "record",
        "Records what a robot publishes, without code on the robot.",
        "“badlog record 1014” looks for the robot of that team and writes all that it publishes on NetworkTables to a WPILOG in the " +
            "folder logs, until Ctrl+C. It publishes nothing. docs/record.md has more examples.",
    ) {
    private val robot by argument("ROBOT").help("A team's number, or an address, such as 10.10.14.2 or localhost:5810.")
    private val out by option("-o", "--out", metavar = "FOLDER").path().default(Path.of("logs"))
        .help("Put logs here; default: logs.")
    private val only by OnlyOption()
    private val isPerEnable by option("--each-enable").flag().help("One log for each time that the robot is enabled.")
    private val isOfAll by option("--all-servers").flag().help("2027: also Systemcore's and the Driver Station's servers.")

    override val examples: List<String> = listOf(
        "record 1014",
        "record 10.10.14.2 --out practice --each-enable",
        "record localhost --only \"SmartDashboard/*\"",
    )

    override val words: List<String> get() = listOf(robot)

    override fun makeTask(): Task {
        val search = try {
            NetworkTablesSearch(robot, robots.addressesOf(robot, null), robots.patience.connect)
        } catch (e: IllegalArgumentException) {
            throw UsageError(e.message.orEmpty())
        }
        val choice = only.choice
        val isWanted: (String) -> Boolean = { name -> isIn(choice, name) }
        val options = RecordOptions(out, isPerEnable, isWanted.takeUnless { choice.isAll })
        val servers = robotServers(isOfAll) { search.find()?.let { ServerAddress(it.host, it.port) } }
        return RecordTask(servers, search.places, options, isJson)
    }

    /** Patterns are for the name in the log, or the robot's name for it. */
    private fun isIn(choice: TopicChoice, name: String): Boolean {
        val bare = name.substringAfter(':')
        return name in choice || bare in choice || bare.trimStart('/') in choice
    }
}
