package badlog.cli.manual

import badlog.cli.BadlogCommand
import badlog.cli.fetch.Robots
import badlog.cli.part.PartLoader
import com.github.ajalt.clikt.completion.CompletionGenerator
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.PrintHelpMessage
import com.github.ajalt.clikt.core.parse
import java.io.File
import java.io.InputStream

/** Writes what a download brings beside the program into the folder that the only argument names: man pages, and completions for shells. */
fun main(arguments: Array<String>) {
    val folder = File(arguments.single())
    for ((path, text) in manual() + completions()) {
        val file = File(folder, path)
        file.parentFile.mkdirs()
        file.writeText(text)
    }
}

/** The pages of the manual by their paths, such as `man/man1/badlog-cut.1`: one of each command, and that of `badlog` itself. */
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

/** The scripts with which shells complete commands, by their paths. */
internal fun completions(): Map<String, String> = listOf("bash", "zsh", "fish").associate { shell ->
    val command = badlogCommand()
    helpOf(emptyList(), command)
    "completions/badlog.$shell" to CompletionGenerator.generateCompletionForCommand(command, shell)
}

private fun pageOf(command: String?) = listOfNotNull(BadlogCommand.NAME, command).joinToString("-")

/** What asking [command] for the help of the sub-command [names] gives: the context in which help is written. */
private fun helpOf(names: List<String>, command: BadlogCommand = badlogCommand()): PrintHelpMessage = try {
    command.parse(names + "--help")
    error("badlog ${names.joinToString(" ")} has no option --help.")
} catch (e: PrintHelpMessage) {
    e
}

/** The program's command line; nothing of what it would run is looked for. */
internal fun badlogCommand(): BadlogCommand =
    BadlogCommand(emptyList(), Robots.ofSystem(), PartLoader.ofProgram(), InputStream.nullInputStream())
