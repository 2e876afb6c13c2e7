package badlog.cli.manual

import badlog.cli.BadlogCommand
import badlog.cli.fetch.Robots
import badlog.cli.plugin.PluginLoader
import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.PrintHelpMessage
import com.github.ajalt.clikt.core.parse
import java.io.File
import java.io.InputStream

/** Writes man pages and shell completions, which are part of a download, to the folder given as the only argument. */
fun main(arguments: Array<String>) {
    val folder = File(arguments.single())
    for ((path, text) in manual() + completions()) {
        val file = File(folder, path)
        file.parentFile.mkdirs()
        file.writeText(text)
    }
}

/** Returns the manual pages by their paths, such as `man/man1/badlog-cut.1`: one for each command, and one for `badlog` itself. */
internal fun manual(): Map<String, String> {
    val names = listOf(null) + badlogCommand().registeredSubcommandNames()
    val pages = names.map { pageOf(it) }
    return names.associate { name ->
        "man/man1/${pageOf(name)}.1" to helpOf(listOfNotNull(name)).let { help ->
            val command = help.context?.command as CoreCliktCommand
            manualPage(pageOf(name), command, checkNotNull(help.context), pages - pageOf(name))
        }
    }
}

/** Returns the completion scripts of shells, by their paths. */
internal fun completions(): Map<String, String> = listOf("bash", "zsh", "fish").associate { shell ->
    val command = badlogCommand()
    helpOf(emptyList(), command)
    "completions/badlog.$shell" to CompletionGenerator.generateCompletionForCommand(command, shell)
}

private fun pageOf(command: String?) = listOfNotNull(BadlogCommand.NAME, command).joinToString("-")

/** Returns the context of the help of the subcommand [names] in [command]. */
private fun helpOf(names: List<String>, command: BadlogCommand = badlogCommand()): PrintHelpMessage = try {
    command.parse(names + "--help")
    error("badlog ${names.joinToString(" ")} has no option --help.")
} catch (e: PrintHelpMessage) {
    e
}

/** Returns the program's command line, without looking for anything that it could run. */
internal fun badlogCommand(): BadlogCommand =
    BadlogCommand(emptyList(), Robots.ofSystem(), PluginLoader.ofProgram(), InputStream.nullInputStream())
