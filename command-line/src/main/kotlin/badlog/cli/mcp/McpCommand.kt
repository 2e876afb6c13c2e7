package badlog.cli.mcp

import badlog.cli.command.ExitCode
import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.plugin.McpService
import badlog.cli.plugin.PluginLoader
import badlog.files.UnreadableFileException
import badlog.files.UserFolders
import badlog.files.requireFolder
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.types.path
import java.io.InputStream
import java.nio.file.Path

internal class McpCommand(private val parts: PluginLoader, private val input: InputStream) :
    SubCommand(
        "mcp",
        "Lets an AI assistant ask about logs.",
        "Speaks the Model Context Protocol over standard input and output, so an assistant starts it, not a person. It only " +
            "reads, and only logs below the folder. docs/assistant.md shows how assistants are configured.",
        hasJson = false,
    ) {
    private val folder by argument("FOLDER").path().help("The folder of logs that the assistant may read.")

    override val examples: List<String> = listOf("mcp logs")

    override val words: List<String> get() = listOf(folder.toString())

    override fun makeTask(): Task = McpTask(folder, parts, input)
}

/** Answers requests from [input] about the logs below [folder]. */
internal class McpTask(private val folder: Path, private val parts: PluginLoader, private val input: InputStream) : Task {
    override fun run(console: Console): ExitCode {
        try {
            requireFolder(folder)
        } catch (e: UnreadableFileException) {
            console.warn(e.message)
            return ExitCode.NOTHING
        }
        val before = System.out
        // A library that prints something would break the protocol.
        System.setOut(System.err)
        try {
            return parts.call("mcp", McpService::class.java, console) {
                it.serve(folder, UserFolders.ofSystem().answers, input, console.bytes, console::warn)
            }
        } finally {
            System.setOut(before)
        }
    }
}
