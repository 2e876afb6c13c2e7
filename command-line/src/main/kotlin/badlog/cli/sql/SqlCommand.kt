package badlog.cli.sql

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.cli.plugin.PluginLoader
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.arguments.optional
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.path
import java.io.InputStream

internal class SqlCommand(private val parts: PluginLoader, private val input: InputStream) :
    SubCommand(
        "sql",
        "Answers SQL about logs.",
        "Logs become tables first, which are cached; later queries read only logs that changed. Without a query, it reads queries from " +
            "the standard input, each ended by a semicolon. Queries read only these tables and change nothing. " +
            "docs/season.md describes the tables.",
    ) {
    private val folder by argument("FOLDER").path().help("A folder of logs, a log, or a lake made by badlog lake.")
    private val query by argument("QUERY").optional().help("Such as 'SELECT title, start FROM matches'.")
    private val isCsv by option("--csv").flag().help("Print CSV.")
    private val parquet by option("--parquet", metavar = "FILE").path().help("Write the answer to this Parquet file.")
    private val explainsTables by option("--explain-tables").flag().help("List the tables and their columns.")

    override val examples: List<String> = listOf(
        "sql logs \"SELECT title, start FROM matches\"",
        "sql logs --explain-tables",
    )

    override val words: List<String> get() = listOfNotNull(folder.toString(), query)

    override fun makeTask(): Task {
        if (listOf(isCsv, isJson, parquet != null, explainsTables).count { it } > 1) {
            throw UsageError("--csv, --json, --parquet and --explain-tables cannot be used together")
        }
        if (explainsTables && query != null) throw UsageError("--explain-tables takes no query")
        if (parquet != null && query == null) throw UsageError("--parquet needs a query")
        val form = when {
            isCsv -> AnswerForm.CSV
            isJson -> AnswerForm.JSON
            else -> AnswerForm.TEXT
        }
        return SqlTask(folder, query, form, parquet, explainsTables, parts, input)
    }
}
