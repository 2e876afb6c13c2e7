package badlog.cli.command

import badlog.cli.text.wrapped
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.NoSuchOption
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.core.requireObject
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option

/** The arguments after the program's name. */
internal class CommandLine(val arguments: List<String>)

/**
 * A subcommand with its options. Parsing only creates a [task], without running it.
 *
 * @param summary its purpose, in one short sentence for the list of all commands.
 * @param details further help; may be empty.
 * @param hasJson whether its results can be JSON.
 */
internal abstract class SubCommand(
    name: String,
    private val summary: String,
    private val details: String,
    private val hasJson: Boolean = true,
) : CoreCliktCommand(name) {
    private val json = option("--json").flag().help("Print one JSON object per line, for programs.")

    /** Whether the results are JSON for programs. */
    protected val isJson: Boolean get() = hasJson && json.value

    private val commandLine by requireObject<CommandLine>()

    /** The requested task; null until the arguments were parsed. */
    var task: Task? = null
        private set

    init {
        if (hasJson) registerOption(json)
    }

    /** Example command lines, without the program's name, each of at most 66 characters. */
    protected open val examples: List<String> get() = emptyList()

    /** All arguments that are not options. */
    protected abstract val words: List<String>

    /** Always true, because Clikt treats an argument that begins with punctuation and contains `=` as an option. */
    final override val treatUnknownOptionsAsArgs: Boolean get() = true

    /** Creates the task for the options; throws a usage error if they contradict each other. */
    protected abstract fun makeTask(): Task

    final override fun run() {
        requireNoOption()
        task = makeTask()
    }

    private fun requireNoOption() {
        // A script's empty variable would otherwise mean the current folder.
        if (words.any { it.isEmpty() }) throw UsageError("an argument is empty; name a log, a folder or a question")
        val before = commandLine.arguments.takeWhile { it != "--" }.toSet()
        val unknown = words.firstOrNull { it.startsWith("-") && it.length > 1 && it in before } ?: return
        val name = unknown.substringBefore('=')
        val names = registeredOptions().flatMap { it.names }
        if (name.startsWith("--") && ' ' !in name) throw NoSuchOption(name, currentContext.suggestTypoCorrection(name, names))
        throw UsageError("there is no option “$unknown”; put -- before it if it is a name or a question")
    }

    final override fun help(context: Context): String =
        listOf(summary, details).filter { it.isNotEmpty() }.joinToString("\n\n", transform = ::paragraph)

    final override fun helpEpilog(context: Context): String =
        examplesText(context.parent?.command?.commandName.orEmpty(), examples) + paragraph(EXIT_CODES)
}

/** Returns the part of a help text with [examples], command lines of [program] without its name. Empty if there are none. */
internal fun examplesText(program: String, examples: List<String>): String =
    if (examples.isEmpty()) "" else examples.joinToString("\n", "Examples:\n", "\n\n") { "  $program $it" }

/** The end of every help text. */
internal const val EXIT_CODES: String =
    "Exit code: 0 success, 3 some data was lost or left out, 1 nothing could be done, 2 wrong usage."

/** Returns [text] in lines that fit a terminal, including the margin of help texts. */
internal fun paragraph(text: String): String = wrapped("", text, width = HELP_WIDTH)

private const val HELP_WIDTH = 76
