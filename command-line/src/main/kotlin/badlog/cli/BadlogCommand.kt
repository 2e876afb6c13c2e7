package badlog.cli

import badlog.cli.assign.AssignCommand
import badlog.cli.command.CommandLine
import badlog.cli.command.EXIT_CODES
import badlog.cli.command.Task
import badlog.cli.command.examplesText
import badlog.cli.command.paragraph
import badlog.cli.computer.Computer
import badlog.cli.convert.ConvertCommand
import badlog.cli.cut.CutCommand
import badlog.cli.doctor.DoctorCommand
import badlog.cli.export.ExportCommand
import badlog.cli.fetch.FetchCommand
import badlog.cli.fetch.Robots
import badlog.cli.find.FindCommand
import badlog.cli.info.InfoCommand
import badlog.cli.lake.LakeCommand
import badlog.cli.mcp.McpCommand
import badlog.cli.merge.MergeCommand
import badlog.cli.open.OpenCommand
import badlog.cli.pack.RulesCommand
import badlog.cli.plugin.PluginLoader
import badlog.cli.record.RecordCommand
import badlog.cli.recover.RecoverCommand
import badlog.cli.replay.ReplayCommand
import badlog.cli.report.ReportCommand
import badlog.cli.sql.SqlCommand
import badlog.cli.table.TableCommand
import badlog.cli.todo.TodoCommand
import badlog.exporter.BADLOG_VERSION
import badlog.formats.READABLE_LOGS
import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.NoSuchSubcommand
import com.github.ajalt.clikt.core.PrintHelpMessage
import com.github.ajalt.clikt.core.PrintMessage
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.core.obj
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import com.github.ajalt.clikt.output.Localization
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.optional
import com.github.ajalt.clikt.parameters.options.versionOption
import com.github.ajalt.clikt.parameters.types.choice
import java.io.InputStream

/**
 * `badlog` and its subcommands. Add a new one here and nowhere else.
 *
 * @property arguments the arguments as typed.
 * @param robots the addresses of robots.
 * @param parts loads some commands only when they are called.
 * @param input the standard input, for commands that communicate with another program.
 * @param computer the computer that badlog runs on.
 */
internal class BadlogCommand(
    val arguments: List<String>,
    robots: Robots = Robots.ofSystem(),
    parts: PluginLoader = PluginLoader.ofProgram(),
    input: InputStream = System.`in`,
    computer: Computer = Computer(),
) : CoreCliktCommand(NAME) {
    private val logCommands = listOf(
        InfoCommand(),
        OpenCommand(computer),
        RecoverCommand(),
        ConvertCommand(parts),
        CutCommand(),
        MergeCommand(),
        ExportCommand(),
        FindCommand(),
        TableCommand(),
        ReportCommand(parts),
        TodoCommand(),
        AssignCommand(),
        RulesCommand(),
        ReplayCommand(),
        RecordCommand(robots),
        FetchCommand(robots),
        LakeCommand(parts),
        SqlCommand(parts, input),
        McpCommand(parts, input),
        DoctorCommand(computer, robots),
    )

    /** The requested task; null if there is none. */
    val task: Task? get() = logCommands.firstNotNullOfOrNull { it.task }

    override val printHelpOnEmptyArgs: Boolean get() = true

    init {
        subcommands(logCommands)
        subcommands(HelpCommand(), CompletionCommand())
        versionOption(BADLOG_VERSION, names = setOf("-V", "--version"), message = { "$NAME $it" })
        context {
            readArgumentFile = null
            obj = CommandLine(arguments)
            localization = object : Localization {
                override fun noSuchSubcommand(name: String, possibilities: List<String>): String {
                    val meant = possibilities.joinToString(" or ") { "“$it”" }
                    return "there is no command “$name”" + if (meant.isEmpty()) "" else "; did you mean $meant?"
                }
            }
        }
    }

    override fun help(context: Context): String = paragraph(
        "Works on robot logs: $READABLE_LOGS; gzipped and damaged ones too. A file's content decides its format, not its name. " +
            "Logs are never changed.",
    )

    override fun helpEpilog(context: Context): String =
        examplesText(NAME, listOf("open logs", "find logs \"min(battery voltage) < 7\"", "fetch 1014")) +
            paragraph("“$NAME help cut” lists the options of cut. $EXIT_CODES")

    override fun run() = Unit

    /** Returns [error], or an error about the first argument if that is not a subcommand. */
    fun explained(error: CliktError): CliktError {
        val first = arguments.firstOrNull()
        val names = registeredSubcommandNames()
        if (error !is UsageError || first == null || first.startsWith("-") || first in names) return error
        return NoSuchSubcommand(first, currentContext.suggestTypoCorrection(first, names)).also { it.context = currentContext }
    }

    companion object {
        /** The name that a person types. */
        const val NAME = "badlog"
    }
}

/** `badlog help cut`: prints the same as `badlog cut --help`. */
internal class HelpCommand : CoreCliktCommand("help") {
    private val command by argument("COMMAND").optional().help("The command to explain.")

    override fun help(context: Context): String = "Explains a command."

    override fun run() {
        val root = currentContext.parent?.command as CoreCliktCommand
        val wanted = command ?: throw PrintHelpMessage(root.currentContext)
        val names = root.registeredSubcommandNames()
        if (wanted !in names) throw NoSuchSubcommand(wanted, currentContext.suggestTypoCorrection(wanted, names))
        root.parse(listOf(wanted, "--help"))
    }
}

/** `badlog completion bash`: prints the completion script of a shell for the commands of [BadlogCommand]. */
internal class CompletionCommand : CoreCliktCommand("completion") {
    private val shell by argument("SHELL").choice("bash", "zsh", "fish").help("bash, zsh or fish.")

    override fun help(context: Context): String = "Prints a script with which a shell completes commands."

    override fun helpEpilog(context: Context): String = paragraph(
        "In ~/.bashrc or ~/.zshrc: source <(badlog completion bash), or zsh. For fish: badlog completion fish > " +
            "~/.config/fish/completions/badlog.fish",
    )

    override fun run() {
        val root = checkNotNull(currentContext.parent).command
        throw PrintMessage(CompletionGenerator.generateCompletionForCommand(root, shell))
    }
}
