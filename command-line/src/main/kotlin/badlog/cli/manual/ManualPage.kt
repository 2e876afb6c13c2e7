package badlog.cli.manual

import badlog.exporter.BADLOG_VERSION
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.PrintHelpMessage
import com.github.ajalt.clikt.output.HelpFormatter.ParameterHelp

/**
 * Returns the manual page [name], such as `badlog-cut`, in the format of `man`. It has the help of [command], and [seeAlso], the names of
 * other pages.
 *
 * @param context the context of the command's help.
 */
internal fun manualPage(name: String, command: CoreCliktCommand, context: Context, seeAlso: List<String>): String = buildString {
    val help = command.help(context).split(PARAGRAPH)
    val parameters = command.allHelpParams()
    appendLine(".TH \"${name.uppercase()}\" 1 \"\" \"badlog $BADLOG_VERSION\" \"badlog\"")
    section("NAME", "$name \\- ${roff(help.first().oneLine().trimEnd('.'))}")
    section("SYNOPSIS", roff(usageOf(command, context)))
    if (help.size > 1) section("DESCRIPTION", help.drop(1).joinToString("\n.PP\n") { roff(it.oneLine()) })
    entries("COMMANDS", parameters.filterIsInstance<ParameterHelp.Subcommand>()) { bold("badlog ${it.name}") to it.help }
    entries("ARGUMENTS", parameters.filterIsInstance<ParameterHelp.Argument>()) { italic(it.name) to it.help }
    entries("OPTIONS", parameters.filterIsInstance<ParameterHelp.Option>()) { headOf(it) to it.help }
    val (examples, remarks) = command.helpEpilog(context).split(PARAGRAPH).partition { it.startsWith(EXAMPLES) }
    val (exit, notes) = remarks.map { it.oneLine() }.filter { it.isNotEmpty() }
        .flatMap { it.split(BEFORE_EXIT_CODE) }.map { it.trim() }.partition { it.startsWith(EXIT_CODE) }
    if (notes.any { it.isNotEmpty() }) section("NOTES", notes.joinToString("\n.PP\n", transform = ::roff))
    val lines = examples.flatMap { it.lines().drop(1) }.map { it.trim() }
    if (lines.isNotEmpty()) section("EXAMPLES", lines.joinToString("\n.PP\n", transform = ::roff))
    if (exit.isNotEmpty()) section("EXIT STATUS", exit.joinToString("\n.PP\n") { roff(it.removePrefix(EXIT_CODE).trim()) })
    if (seeAlso.isNotEmpty()) section("SEE ALSO", seeAlso.joinToString(", ") { "${bold(it)}(1)" })
}

private fun StringBuilder.section(title: String, text: String) {
    appendLine(".SH $title").appendLine(text)
}

private fun <T> StringBuilder.entries(title: String, entries: List<T>, parts: (T) -> Pair<String, String>) {
    if (entries.isEmpty()) return
    appendLine(".SH $title")
    for ((head, text) in entries.map(parts)) appendLine(".TP").appendLine(head).appendLine(roff(text.oneLine()))
}

/** Returns `badlog cut [<options>] <log>...`, as in the help. */
private fun usageOf(command: CoreCliktCommand, context: Context): String =
    command.getFormattedHelp(PrintHelpMessage(context)).orEmpty().substringBefore("\n\n").oneLine().removePrefix("Usage: ")

private fun headOf(option: ParameterHelp.Option): String {
    val names = option.names.sortedBy { it.length }.joinToString(", ", transform = ::bold)
    val value = option.metavar?.takeIf { option.nvalues.last > 0 } ?: return names
    return "$names=${italic(value.trim('<', '>').lowercase())}"
}

private fun bold(text: String) = "\\fB${roff(text)}\\fR"

private fun italic(text: String) = "\\fI${roff(text)}\\fR"

private fun String.oneLine() = trim().replace(SPACES, " ")

/** Returns [text] with everything escaped that `man` would take for a command, a hyphen or a character of another encoding. */
private fun roff(text: String): String = buildString {
    if (text.startsWith('.') || text.startsWith('\'')) append("\\&")
    for (char in text) {
        when {
            char == '\\' -> append("\\e")
            char == '-' -> append("\\-")
            char.code < FIRST_NOT_ASCII -> append(char)
            else -> append("\\[u%04X]".format(char.code))
        }
    }
}

private const val EXAMPLES = "Examples:"
private const val EXIT_CODE = "Exit code:"
private const val FIRST_NOT_ASCII = 0x80
private val BEFORE_EXIT_CODE = Regex("(?=$EXIT_CODE)")
private val PARAGRAPH = Regex("\n[ ]*\n")
private val SPACES = Regex("\\s+")
