package badlog.cli.command

import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.types.path
import java.nio.file.Path

/**
 * A [SubCommand] over logs.
 *
 * @param logHelp the help for the argument `LOG`.
 * @param needsLog whether there must be one.
 */
internal abstract class LogCommand(
    name: String,
    summary: String,
    details: String,
    logHelp: String = "A log, or a folder: all logs in it, at any depth.",
    needsLog: Boolean = true,
) : SubCommand(name, summary, details) {
    /** The files and folders given as arguments. */
    protected val paths: List<Path> by argument("LOG").path().multiple(required = needsLog).help(logHelp)

    override val words: List<String> get() = paths.map { it.toString() }
}
