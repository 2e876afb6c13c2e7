package badlog.cli.table

import badlog.cli.command.ExitCode
import badlog.cli.command.LogCommand
import badlog.cli.command.LogFiles
import badlog.cli.command.Outcome
import badlog.cli.command.Outcomes
import badlog.cli.command.ResultForm
import badlog.cli.command.Task
import badlog.cli.command.VirtualTopicOption
import badlog.cli.console.Console
import badlog.cli.search.HookOptions
import badlog.cli.search.rulesBeside
import badlog.cli.text.jsonOf
import badlog.cli.topic.OnlyOption
import badlog.cli.topic.TopicChoice
import badlog.files.UserFolders
import badlog.report.table.MatchTable
import badlog.report.table.TableRow
import badlog.report.table.TableRowJson
import badlog.report.table.notesOf
import badlog.report.table.tableCsv
import badlog.report.table.tableText
import badlog.signals.vocabulary.SignalVocabulary
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import java.nio.file.Path

internal class TableCommand :
    LogCommand(
        "table",
        "Makes a table with a row per log.",
        "Each --value is an expression, such as 'min(battery voltage)', and gives a column; so does each value that a --hook " +
            "returns. Each topic of --only gets columns for its min, mean and max. Answers are cached as in find, except " +
            "results of hooks. Without a column, --by battery makes a table with a row per battery.",
    ) {
    private val values by option("--value", metavar = "EXPRESSION").multiple().help("A column; may be repeated.")
    private val only by OnlyOption()
    private val by by option("--by", metavar = "NAME").multiple()
        .help("A column for this header value; it sorts the rows.")
    private val condition by option(
        "--where",
        metavar = "CONDITION",
    ).help("Only logs with this value: \"Match Type = 'Playoff'\".")
    private val isCsv by option("--csv").flag().help("Print CSV.")
    private val hooks by HookOptions()
    private val virtual by VirtualTopicOption()
    private val xTopic by option("--x", metavar = "TOPIC").help("Use this topic as x axis; CSV does not name one.")
    private val isFresh by option("--no-cache").flag().help("Read every log again, and store no results.")

    override val examples: List<String> = listOf(
        "table logs --value \"min(battery voltage)\" --by \"Match Number\"",
        "table logs --only \"PDP/Current *\" --csv",
        "table logs --by battery",
    )

    override fun makeTask(): Task {
        val form = ResultForm.of(isCsv, isJson)
        val cache = if (isFresh) null else UserFolders.ofSystem().answers
        val hasColumns = values.isNotEmpty() || hooks.runners.isNotEmpty() || !only.choice.isAll
        if (!hasColumns && by.singleOrNull().equals(MatchTable.BATTERY, ignoreCase = true)) {
            if (condition != null || xTopic != null || virtual.definitions.isNotEmpty()) {
                throw UsageError("--where, --x and virtual topics need a column: --value EXPRESSION")
            }
            return BatteryTask(paths, cache, form)
        }
        if (!hasColumns) {
            throw UsageError("name a column: --value EXPRESSION, --only PATTERN or --hook COMMAND")
        }
        return TableTask(
            paths,
            only.choice,
            { signals ->
                MatchTable(values, by, hooks.runners, condition, virtual.definitions, cache, xTopic, signals, only.choice.patterns)
            },
            form,
        )
    }
}

/**
 * Makes the table that [tableWith] returns for the signals of the logs' folder. It has a row for every log below [paths], and columns for
 * the topics of [only].
 */
internal class TableTask(
    private val paths: List<Path>,
    private val only: TopicChoice,
    private val tableWith: (SignalVocabulary) -> MatchTable,
    private val form: ResultForm,
) : Task {
    override fun run(console: Console): ExitCode {
        val table = tableWith(rulesBeside(paths, console::warn).signals)
        table.mistake?.let {
            console.warn(it.pointed)
            return ExitCode.USAGE
        }
        val logs = LogFiles(paths, console)
        val rows = console.progress("table").use { bar ->
            table.over(logs.files, paths, console::warn) { done, total -> bar.advanced(done.toLong(), total.toLong()) }
        }
        table.mistakeIn(rows)?.let {
            // A topic missing in the question may be one that could not be calculated.
            notesOf(rows).forEach(console::warn)
            console.warn(it.pointed)
            return ExitCode.USAGE
        }
        if (!only.isAll && rows.all { it.topics.isEmpty() }) {
            console.warn("No log has a topic that matches ${only.text}; “badlog info --topics” lists the topics of a log.")
        }
        if (rows.any { !it.isNoLog }) say(table, rows, console)
        val isJson = form == ResultForm.JSON
        val outcomes = Outcomes("table", console, isJson, isSummed = true)
        val rowOf = rows.associateBy { it.file }
        logs.report(outcomes) { input, file ->
            val row = rowOf.getValue(file)
            val unreadable = row.unreadable
            when {
                unreadable != null -> outcomes.unreadable(input, unreadable, row.isNoLog)

                else -> outcomes.done(
                    input.file,
                    Outcome(
                        row.isSalvaged || row.hookFailures.isNotEmpty(),
                        "",
                        if (isJson) jsonOf(TableRowJson(table, row)) else emptyMap(),
                    ),
                )
            }
        }
        return outcomes.end()
    }

    private fun say(table: MatchTable, rows: List<TableRow>, console: Console) {
        when (form) {
            ResultForm.TEXT -> console.say(tableText(table, rows, console.width))
            ResultForm.CSV -> console.say(tableCsv(table, rows).trimEnd())
            ResultForm.JSON -> return
        }
        notesOf(rows).forEach(console::warn)
    }
}
