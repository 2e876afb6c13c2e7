package badlog.assistant

import badlog.assistant.call.AssistantTool
import badlog.assistant.log.LogFolder
import badlog.assistant.log.LogLake
import badlog.assistant.log.OpenLogs
import badlog.assistant.tool.DescribeLog
import badlog.assistant.tool.FindInLogs
import badlog.assistant.tool.FindingsOfLogs
import badlog.assistant.tool.GraphOfTopics
import badlog.assistant.tool.ListLogs
import badlog.assistant.tool.SamplesOfTopics
import badlog.assistant.tool.SqlOverLogs
import badlog.assistant.tool.StatisticsOfTopics
import badlog.assistant.tool.TableOfLogs
import badlog.cli.command.ExitCode
import badlog.cli.plugin.McpService
import badlog.cli.plugin.SeasonService
import badlog.files.UnreadableFileException
import kotlinx.coroutines.runBlocking
import java.io.InputStream
import java.io.OutputStream
import java.nio.file.Path
import java.util.ServiceLoader

/** The service behind `badlog mcp`. */
internal class Assistant : McpService {
    override fun serve(folder: Path, cache: Path, input: InputStream, output: OutputStream, warn: (String) -> Unit): ExitCode {
        val logs = try {
            LogFolder(folder)
        } catch (e: UnreadableFileException) {
            warn(e.message)
            return ExitCode.NOTHING
        }
        // Graphs are drawn without a screen.
        System.setProperty("java.awt.headless", "true")
        // The protocol's library prints a greeting that looks like an error.
        System.setProperty("kotlin-logging.logStartupMessage", "false")
        val lake = seasonService()?.let { LogLake(logs, cache, it) }
        runBlocking { AssistantServer(toolsOf(logs, cache, lake), logs.root.toString()).serve(input, output) }
        return ExitCode.WHOLE
    }
}

/** Returns the service that makes tables of logs; null if it is not installed. */
internal fun seasonService(): SeasonService? =
    ServiceLoader.load(SeasonService::class.java, Assistant::class.java.classLoader).firstOrNull()

/**
 * Returns all tools for [logs].
 *
 * @param cache the folder for cached answers; null for none.
 * @param lake the tables of the logs; null if nothing can make them.
 */
internal fun toolsOf(logs: LogFolder, cache: Path?, lake: LogLake?): List<AssistantTool> {
    val open = OpenLogs(logs)
    return listOfNotNull(
        ListLogs(logs, cache),
        DescribeLog(open),
        FindingsOfLogs(logs, cache),
        FindInLogs(logs, cache),
        TableOfLogs(logs, cache),
        lake?.let { SqlOverLogs(it) },
        StatisticsOfTopics(open),
        SamplesOfTopics(open),
        GraphOfTopics(open),
    )
}
