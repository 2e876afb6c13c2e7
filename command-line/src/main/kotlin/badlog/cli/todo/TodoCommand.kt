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
import com.github.ajalt.clikt.parameters.types.path

/** `badlog todo`. */
internal class TodoCommand :
    SubCommand(
        "todo",
        "Prints what a team has to do, from what rules found and people wrote.",
        "The window writes the list beside the logs, in a file per laptop; all of them are read. Errors of the last matches are on it " +
            "by themselves, and what was done comes back when it is found in a later log. docs/todo.md explains the files.",
    ) {
    private val folder by argument("FOLDER").path().help("The folder of the logs.")
    private val isMarkdown by option("--markdown").flag().help("Print Markdown, for a wiki or a chat.")
    private val page by option("-o", "--out", metavar = "FILE").path().help("Also write the list as a page there: list.html.")
    private val isForced by option("--force").flag().help("Replace a file that is not such a page.")
    private val isFresh by option("--no-cache").flag().help("Read every log again, and store no results.")

    override val examples: List<String> = listOf("todo logs", "todo logs --markdown", "todo logs --out list.html")

    override val words: List<String> get() = listOf("$folder")

    override fun makeTask(): Task {
        if (isMarkdown && isJson) throw UsageError("--markdown and --json cannot be used together")
        if (isForced && page == null) throw UsageError("--force needs --out, since nothing else is written")
        val form = when {
            isMarkdown -> TodoForm.MARKDOWN
            isJson -> TodoForm.JSON
            else -> TodoForm.TEXT
        }
        return TodoTask(folder, form, page?.let { PagePlan(it, isForced) }, if (isFresh) null else UserFolders.ofSystem().answers)
    }
}

/** How a list is printed. */
internal enum class TodoForm { TEXT, MARKDOWN, JSON }
