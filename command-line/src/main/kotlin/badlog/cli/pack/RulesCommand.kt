package badlog.cli.pack

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.cli.input.position
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.optional
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.path

internal class RulesCommand :
    SubCommand(
        "rules",
        "Begins and checks packs of rules.",
        "A pack is a folder, or a zip of it, with rules and with slices: pieces of logs in which a rule must find something, or must " +
            "not. “check” runs the rules over all slices. “new” begins a pack with the 20 s around a moment of a log, or adds them to " +
            "one, without team number, IP addresses, user names and paths. Beside logs, a pack is used if its name ends in " +
            ".badlog-rules or .badlog-rules.zip; you may leave out the ending here. docs/rules.md describes packs.",
    ) {
    private val action by argument("ACTION").choice(CHECK, NEW).help("check or new.")
    private val pack by argument("PACK").path().optional().help("The folder or zip of the pack.")
    private val from by option("--from", metavar = "LOG").path().help("With new: the log.")
    private val at by option("--at", metavar = "SECONDS").position().help("With new: the moment on the x axis, or as 1:32.5.")
    private val name by option("--name", metavar = "TEXT").help("With new: the name of the rule.")
    private val condition by option("--when", metavar = "CONDITION")
        .help("With new: the rule's condition; default: what is unusual.")
    private val isSilent by option("--silent").flag().help("With new: the rule must find nothing in this slice.")

    override val examples: List<String> = listOf(
        "rules new shooter --from q42.bag --at 93.7 --name \"Shooter jammed\"",
        "rules check shooter",
    )

    override val words: List<String> get() = listOfNotNull(action, pack?.toString())

    override fun makeTask(): Task {
        val pack = pack ?: throw UsageError("name the pack: $action PACK")
        if (action == CHECK) {
            if (listOfNotNull(from, at, name, condition).isNotEmpty() || isSilent) {
                throw UsageError("check takes only a pack; --from, --at, --name, --when and --silent belong to new")
            }
            return PackCheckTask(PackPlace.existing(pack), isJson)
        }
        val log = from ?: throw UsageError("name the log with --from")
        val moment = at ?: throw UsageError("name the moment with --at")
        val rule = name?.trim()?.ifEmpty { null } ?: throw UsageError("name the rule with --name")
        return NewSliceTask(PackPlace.forWriting(pack), SliceOrder(log, moment, rule, condition, isSilent), isJson)
    }
}

private const val CHECK = "check"
private const val NEW = "new"
