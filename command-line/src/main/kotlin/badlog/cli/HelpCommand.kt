package badlog.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.NoSuchSubcommand
import com.github.ajalt.clikt.core.PrintHelpMessage
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.optional

/** `badlog help cut`: says what `badlog cut --help` says. */
internal class HelpCommand : CoreCliktCommand("help") {
    private val command by argument("COMMAND").optional().help("The sub-command that is wondered about.")

    override fun help(context: Context): String = "Says what a sub-command does."

    override fun run() {
        val root = currentContext.parent?.command as CoreCliktCommand
        val wanted = command ?: throw PrintHelpMessage(root.currentContext)
        val names = root.registeredSubcommandNames()
        if (wanted !in names) throw NoSuchSubcommand(wanted, currentContext.suggestTypoCorrection(wanted, names))
        root.parse(listOf(wanted, "--help"))
    }
}
