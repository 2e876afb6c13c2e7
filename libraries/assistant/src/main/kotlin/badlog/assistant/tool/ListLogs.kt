package badlog.assistant.tool

import badlog.assistant.call.Answer
import badlog.assistant.call.Arguments
import badlog.assistant.call.AssistantTool
import badlog.assistant.call.Page
import badlog.assistant.call.Parameter
import badlog.assistant.call.ParameterType
import badlog.assistant.log.LogFolder
import badlog.files.LogFile
import badlog.report.table.MatchTable
import badlog.report.table.TableRow
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import java.nio.file.Path
import java.time.Instant

/**
 * Lists the logs of the folder.
 *
 * @param cache where the matches of logs are cached.
 */
internal class ListLogs(private val logs: LogFolder, private val cache: Path?) :
    AssistantTool(
        "list_logs",
        "List logs",
        "Lists the logs: name (for the other tools), match, size in bytes, when the file was written (UTC), and whether some of it is " +
            "lost. “containing” keeps the logs whose name or match contains a text.",
        listOf(Parameter("containing", ParameterType.TEXT, "Only logs whose name or match contains this, in any case; default: all.")) +
            Page.PARAMETERS,
    ) {
    override fun answer(arguments: Arguments): Answer {
        val all = logs.logs().toList()
        val part = arguments.text("containing").orEmpty()
        val rows = HashMap<LogFile, TableRow>()

        // The match of a log is known only after reading it.
        fun readMatches(files: List<LogFile>) = MatchTable(emptyList(), cache = cache).over(files).associateByTo(rows) { it.file }
        val wanted = if (part.isEmpty()) {
            all
        } else {
            readMatches(all.map { it.second })
            all.filter { (name, file) -> listOfNotNull(name, rows.getValue(file).title).any { it.contains(part, ignoreCase = true) } }
        }
        val page = Page.of(wanted, arguments) { shown ->
            readMatches(shown.map { it.second }.filter { it !in rows })
            shown.map { (name, file) -> json(name, file, rows.getValue(file)) }
        }
        return Answer(buildJsonObject { page.putInto(this, "logs") })
    }

    private fun json(name: String, file: LogFile, row: TableRow): JsonObject = buildJsonObject {
        put("log", name)
        row.title?.let { put("match", it) }
        put("bytes", file.size)
        put("written", Instant.ofEpochMilli(file.modified).toString())
        if (row.isSalvaged) put("isDamaged", true)
        row.unreadable?.let { put("unreadable", it) }
    }
}
