package badlog.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path

/**
 * The options of one sub-command, and what they ask for. Parsing does nothing yet: it ends with a [task].
 *
 * @param summary what it does, in one short sentence, which stands in the list of all.
 * @param details what else there is to know; may be empty.
 */
internal abstract class SubCommand(
    name: String,
    private val summary: String,
    private val details: String,
) : CoreCliktCommand(name) {
    /** The files and folders that were named. */
    protected val paths: List<Path> by argument("LOG").path().multiple(required = true)
        .help("A log, or a folder: all logs in it, at any depth.")

    /** Whether programs read the results. */
    protected val isJson: Boolean by option("--json").flag().help("Print one JSON object a line, for programs.")

    /** What was asked for; null until its arguments were parsed. */
    var task: Task? = null
        private set

    /** Makes the task that the options ask for; throws a usage error where they contradict each other. */
    protected abstract fun makeTask(): Task

    final override fun run() {
        task = makeTask()
    }

    final override fun help(context: Context): String =
        listOf(summary, details).filter { it.isNotEmpty() }.joinToString("\n\n", transform = ::paragraph)

    final override fun helpEpilog(context: Context): String = paragraph(EXIT_CODES)
}
