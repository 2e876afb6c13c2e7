package badlog.cli.todo

import badlog.catalog.todo.TodoFiles
import badlog.catalog.todo.TodoFolder
import badlog.cli.command.ExitCode
import badlog.cli.command.LogFiles
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.input.Failure
import badlog.cli.search.rulesBeside
import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import badlog.files.naming
import badlog.files.requireFolder
import badlog.files.requireTarget
import badlog.files.writeAtomically
import badlog.files.writing
import badlog.report.LogReport
import badlog.report.Report
import badlog.report.page.foreignFileSentence
import badlog.signals.match.localSecondOf
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.todo.FoundFault
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoLog
import badlog.viewer.todo.isTodoPage
import badlog.viewer.todo.toMarkdown
import badlog.viewer.todo.toPage
import java.nio.file.Files
import java.nio.file.Path

/**
 * Prints the list that is beside the logs in [folder].
 *
 * @param page the file for the list as a page; null for none.
 * @param cache the folder for cached findings; null for none.
 * @param mark a change to make first; null for none.
 */
internal class TodoTask(
    private val folder: Path,
    private val form: TodoForm,
    private val page: PagePlan?,
    private val cache: Path?,
    private val mark: TodoMark?,
) : Task {
    override fun run(console: Console): ExitCode {
        val files = try {
            requireFolder(folder)
            TodoFolder(folder).read()
        } catch (e: UnreadableFileException) {
            console.warn(e.message)
            return ExitCode.NOTHING
        }
        val rules = rulesBeside(listOf(folder), console::warn)
        val logs = LogFiles(listOf(folder), console).files
        val result = console.progress("todo").use { bar ->
            Report(rules, cache = cache).over(logs, { done, total -> bar.advanced(done.toLong(), total.toLong()) })
        }
        val now = localSecondOf(System.currentTimeMillis() / MILLIS)
        val found = result.logs.filter { it.unreadable == null }.map { foundIn(it, now) }
        val list = try {
            marked(files, found, console)
        } catch (e: Failure) {
            console.warn(e.message)
            return ExitCode.USAGE
        } catch (e: UnwritableFileException) {
            console.warn(e.message)
            return ExitCode.NOTHING
        }
        val lines = (rules.checklist + files.checklist).distinct()
        if (page != null && !written(page, list, lines, console)) return ExitCode.NOTHING
        when (form) {
            TodoForm.TEXT -> console.say(todoText(list, lines, console.width))
            TodoForm.MARKDOWN -> console.say(list.toMarkdown(lines).trimEnd())
            TodoForm.JSON -> for (line in todoJson(list, lines)) console.say(Spelling.ascii("$line"))
        }
        return codeOf(files, result.logs, console)
    }

    /** Returns the list, with the change of [mark]. */
    private fun marked(files: TodoFiles, logs: List<TodoLog>, console: Console): TodoList {
        val before = TodoList.of(files.changes, logs)
        if (mark == null) return before
        val change = mark.changeOf(before, logs, files.changes)
        if (change != null) TodoFolder(folder).append(change)
        if (form != TodoForm.JSON) console.warn(mark.sentenceFor(before, change))
        return if (change == null) before else TodoList.of(files.changes + change, logs)
    }

    private fun written(page: PagePlan, list: TodoList, lines: List<String>, console: Console): Boolean = try {
        page.write(list.toPage("${folder.toAbsolutePath().normalize().fileName ?: folder}", lines))
        if (form != TodoForm.JSON) console.warn("The page is ${page.file}.")
        true
    } catch (e: UnwritableFileException) {
        console.warn(e.message)
        false
    }

    private fun codeOf(files: TodoFiles, logs: List<LogReport>, console: Console): ExitCode {
        files.problems.forEach(console::warn)
        val unreadable = logs.filter { it.unreadable != null && !it.isNoLog }
        for (log in unreadable) console.warn(naming(log.file.path, log.unreadable.orEmpty()))
        return if (files.problems.isEmpty() && unreadable.isEmpty()) ExitCode.WHOLE else ExitCode.SALVAGED
    }
}

private fun foundIn(log: LogReport, now: Long): TodoLog {
    val date = log.began?.let { LogDate(it, DateSource.VALUES) } ?: LogDate.of(emptyList(), log.file.name, log.file.modified)
    return TodoLog.of(log.file.name, log.match, date, now, log.findings.map(FoundFault::of))
}

private const val MILLIS = 1000L

/** The [file] for a page. If [isForced], it replaces any other file there. */
internal class PagePlan(val file: Path, private val isForced: Boolean) {
    /**
     * Writes [page].
     *
     * @throws UnwritableFileException if it cannot be written or would replace something else.
     */
    fun write(page: String) {
        requireTarget(file)
        if (!isForced && Files.exists(file) && !isTodoPage(beginOf(file))) throw UnwritableFileException(file, foreignFileSentence(file))
        writeAtomically(file) { it.write(page.encodeToByteArray()) }
    }

    private fun beginOf(file: Path) = writing(file) { Files.newInputStream(file).use { it.readNBytes(BEGIN).decodeToString() } }
}

private const val BEGIN = 1024
