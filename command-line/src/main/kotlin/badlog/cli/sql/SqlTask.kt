package badlog.cli.sql

import badlog.cli.command.ExitCode
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcomes
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.lake.refreshed
import badlog.cli.plugin.LakeCache
import badlog.cli.plugin.PluginLoader
import badlog.cli.plugin.SeasonException
import badlog.cli.plugin.SeasonService
import badlog.cli.plugin.SqlSession
import badlog.cli.plugin.WrongQueryException
import badlog.cli.text.LINE_WIDTH
import badlog.cli.text.counted
import badlog.cli.text.wrapped
import badlog.files.UserFolders
import java.io.InputStream
import java.nio.file.Path

/**
 * Answers [query] about the logs below [folder], or the queries in [input] if it is null.
 *
 * @param parquet the file that receives the answer instead; null for none.
 * @param explainsTables whether to list the tables instead.
 */
internal class SqlTask(
    private val folder: Path,
    private val query: String?,
    private val form: AnswerForm,
    private val parquet: Path?,
    private val explainsTables: Boolean,
    private val parts: PluginLoader,
    private val input: InputStream,
) : Task {
    override fun run(console: Console): ExitCode = parts.call("sql", SeasonService::class.java, console) { service ->
        try {
            val (lake, code) = lakeOf(service, console)
            if (lake == null) code else service.open(lake, parquet).use { answer(it, console) ?: code }
        } catch (e: WrongQueryException) {
            console.warn(e.message)
            ExitCode.USAGE
        } catch (e: SeasonException) {
            console.warn(e.message)
            ExitCode.NOTHING
        }
    }

    /**
     * Returns [folder] if it is a lake, otherwise its updated lake, or null if it has no logs. Comes with the exit code for missing logs.
     */
    private fun lakeOf(service: SeasonService, console: Console): Pair<Path?, ExitCode> {
        if (service.isLake(folder)) return folder to ExitCode.WHOLE
        val logs = LogFiles(listOf(folder), console, opensMatches = true)
        if (logs.files.isEmpty()) {
            val outcomes = Outcomes("sql", console, isJson = false)
            logs.report(outcomes) { _, _ -> }
            return null to outcomes.end()
        }
        val lake = LakeCache(UserFolders.ofSystem().answers, service.layoutVersion).lakeOf(folder)
        val report = refreshed(service, lake, listOf(folder), logs, console, waits = true)
        val missing = report.logs.filter { it.message != null && !it.isNoLog }
        for (log in missing) console.warn(log.message.orEmpty())
        return lake to if (missing.isEmpty()) ExitCode.WHOLE else ExitCode.SALVAGED
    }

    /** Answers the query; returns null, or an exit code to use in place of the lake's. */
    private fun answer(session: SqlSession, console: Console): ExitCode? = when {
        explainsTables -> null.also { explain(session, console) }

        query == null -> SqlPrompt(session, form, console).run(input).let { null }

        parquet != null -> null.also {
            val rows = session.write(query)
            console.say("$parquet: ${counted(rows, "row")}")
        }

        else -> null.also { form.print(session, query, console) }
    }

    private fun explain(session: SqlSession, console: Console) {
        for (table in session.tables()) {
            console.say("${table.name}: ${table.meaning}")
            val columns = table.columns.joinToString { "${nameOf(it.name)} ${it.type.lowercase()}" }
            console.say(wrapped("  ", columns, INDENT, minOf(console.width, LINE_WIDTH)))
        }
    }

    private fun nameOf(name: String) = if (PLAIN.matches(name)) name else "\"${name.replace("\"", "\"\"")}\""

    private companion object {
        const val INDENT = 2
        val PLAIN = Regex("[a-z_][a-z0-9_]*")
    }
}
