package badlog.cli

import badlog.cli.command.ExitCode
import badlog.cli.computer.Computer
import badlog.cli.console.Console
import badlog.cli.console.StandardStreams
import badlog.cli.console.unreachable
import badlog.cli.console.withWildcards
import badlog.cli.fetch.Robots
import badlog.cli.plugin.PluginLoader
import badlog.files.bugSentence
import badlog.files.tooLargeSentence
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.parse
import java.io.IOException
import java.io.InputStream

/**
 * The command line: parses the arguments, then runs the command.
 *
 * @param input the standard input, which `-` among the logs stands for.
 * @param robots the addresses of robots.
 * @param parts loads some commands only when they are called.
 * @param computer the computer that badlog runs on.
 */
internal class Badlog(
    private val console: Console,
    private val input: InputStream = System.`in`,
    private val robots: Robots = Robots.ofSystem(),
    private val parts: PluginLoader = PluginLoader.ofProgram(),
    private val computer: Computer = Computer(),
) {
    /** Runs the command in [arguments]. */
    fun run(arguments: List<String>): ExitCode = try {
        StandardStreams(withWildcards(arguments, computer.system), input).use { streams ->
            val console = console.naming(streams.names, isOutTaken = streams.hasResult)
            run(streams.arguments, console).also { streams.giveResult(this.console::give) }
        }
    } catch (e: IOException) {
        console.warn("The standard input cannot be kept while it is read (${e.message}); make room in the folder for temporary files.")
        ExitCode.NOTHING
    }

    private fun run(arguments: List<String>, console: Console): ExitCode {
        val command = BadlogCommand(arguments, robots, parts, input, computer)
        val task = try {
            command.parse(arguments)
            command.task ?: return ExitCode.USAGE
        } catch (e: CliktError) {
            return say(command, command.explained(e), arguments, console)
        }
        return try {
            task.run(console)
        } catch (_: OutOfMemoryError) {
            console.warn(tooLargeSentence("What is asked for"))
            ExitCode.NOTHING
        } catch (e: Exception) {
            console.warn(bugSentence(e))
            ExitCode.NOTHING
        }
    }

    private fun say(command: BadlogCommand, what: CliktError, arguments: List<String>, console: Console): ExitCode {
        val text = command.getFormattedHelp(what).orEmpty().trim()
        if (what.statusCode == 0) {
            console.say(text)
            return ExitCode.WHOLE
        }
        val unreachable = if (NO_PATH in text) unreachable(arguments, text, computer.system) else null
        if (unreachable != null) {
            console.warn(unreachable)
            return ExitCode.USAGE
        }
        // The usage line before it is not needed, since the help is better.
        val reason = text.substringAfter(ERROR).replaceFirstChar(Char::uppercase)
        val inside = arguments.first().takeIf { it in command.registeredSubcommandNames() }
        val help = listOfNotNull(BadlogCommand.NAME, "help", inside).joinToString(" ")
        console.warn("$reason${if (reason.last() in ".?") "" else "."} Try: $help")
        return ExitCode.USAGE
    }
}

private const val ERROR = "Error: "

/** The beginning of Java's message on Windows about a path with a `?` or `*`. */
private const val NO_PATH = "Illegal char <"
