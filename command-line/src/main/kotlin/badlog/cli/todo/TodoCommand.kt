package badlog.cli.todo

import badlog.cli.command.SubCommand
import badlog.cli.command.Task
import badlog.files.UserFolders
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.help
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.help
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.path

internal class TodoCommand :
    SubCommand(
        "todo",
        "Prints the team's to-do list: findings of rules, and items that people wrote.",
        "The list is beside the logs, in a file per laptop; all of them are read. Errors of the last matches are added to it, " +
            "and an item that was done returns if it is found in a later log. docs/todo.md explains the files.",
    ) {
    private val folder by argument("FOLDER").path().help("The folder of the logs.")
    private val isMarkdown by option("--markdown").flag().help("Print Markdown, for a wiki or a chat.")
    private val page by option("-o", "--out", metavar = "FILE").path().help("Also write the list as a page there: list.html.")
    private val isForced by option("--force").flag().help("Replace a file that is not such a page.")
    private val done by option("--done", metavar = "N").int().help("Mark the item with this number as done.")
    private val open by option("--open", metavar = "N").int().help("Mark it as open again.")
    private val what by option("--what", metavar = "TEXT").help("The work done.")
    private val author by option("--by", metavar = "NAME").help("Who did it; default: the name of your account.")
    private val isFresh by option("--no-cache").flag().help("Read every log again, and store no results.")

    override val examples: List<String> = listOf("todo logs", "todo logs --done 2 --what \"new breaker\"", "todo logs --out list.html")

    override val words: List<String> get() = listOf("$folder")

    override fun makeTask(): Task {
        if (isMarkdown && isJson) throw UsageError("--markdown and --json cannot be used together")
        if (isForced && page == null) throw UsageError("--force needs --out, since nothing else is written")
        if (done != null && open != null) throw UsageError("--done and --open cannot be used together")
        if (what != null && done == null) throw UsageError("--what needs --done")
        if (author != null && done == null && open == null) throw UsageError("--by needs --done or --open")
        val form = when {
            isMarkdown -> TodoForm.MARKDOWN
            isJson -> TodoForm.JSON
            else -> TodoForm.TEXT
        }
        val cache = if (isFresh) null else UserFolders.ofSystem().answers
        return TodoTask(folder, form, page?.let { PagePlan(it, isForced) }, cache, (done ?: open)?.let(::markOf))
    }

    private fun markOf(number: Int): TodoMark {
        val account = System.getProperty("user.name").orEmpty().ifBlank { "somebody" }
        return TodoMark(number, isDone = done != null, what.orEmpty().trim(), author.orEmpty().ifBlank { account })
    }
}

/** The form of a printed list. */
internal enum class TodoForm { TEXT, MARKDOWN, JSON }
