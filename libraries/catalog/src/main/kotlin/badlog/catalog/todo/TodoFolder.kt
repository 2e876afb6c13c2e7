package badlog.catalog.todo

import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import badlog.files.appendLines
import badlog.files.appendedText
import badlog.files.computerName
import badlog.files.fileNamePart
import badlog.files.reading
import badlog.rules.RulesFile
import badlog.viewer.todo.CHECKLIST_FILE
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.checklistOf
import badlog.viewer.todo.toLine
import badlog.viewer.todo.todoChangesOf
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * A team's to-do list beside the logs in [folder]. Each computer appends to a file of its own, so that synced folders and git have no
 * conflicts; all files are read. Lines are never changed. Do not call it on the window's thread.
 *
 * @param computer the unique name of this computer; null to look it up, which takes a while.
 */
class TodoFolder(private val folder: Path, computer: String? = null) {
    /** The file of this computer. */
    val file: Path by lazy { folder.resolve("$BEGIN-${fileNamePart(computer ?: computerName)}$ENDING") }

    /**
     * Returns the changes of all computers.
     *
     * @throws UnreadableFileException if the folder cannot be listed.
     */
    fun read(): TodoFiles {
        val changes = ArrayList<TodoChange>()
        val problems = ArrayList<String>()
        var isWhole = true
        for (file in files()) {
            try {
                val lines = todoChangesOf(appendedText(file))
                changes += lines.changes
                lines.problemOf(file.name)?.let(problems::add)
            } catch (e: UnreadableFileException) {
                problems += e.message
                isWhole = false
            }
        }
        val checklist = try {
            folder.resolve(CHECKLIST_FILE).takeIf(Files::isRegularFile)?.let { checklistOf(appendedText(it)) }.orEmpty()
        } catch (e: UnreadableFileException) {
            problems += e.message
            emptyList()
        }
        return TodoFiles(changes, checklist, problems, isWhole)
    }

    /** Returns a stamp that changes with the results of [read] or the checklist in the folder's rules. It does not read the files. */
    fun stamp(): List<Any> = try {
        (files() + listOf(CHECKLIST_FILE, RulesFile.NAME).map(folder::resolve)).filter(Files::isRegularFile).map {
            Triple(it, Files.size(it), Files.getLastModifiedTime(it))
        }
    } catch (_: IOException) {
        emptyList()
    }

    /**
     * Appends [change] as one line.
     *
     * @throws UnwritableFileException if it cannot be written.
     */
    fun append(change: TodoChange) = appendLines(file, listOf(change.toLine()))

    private fun files(): List<Path> = reading(folder) {
        folder.listDirectoryEntries("$BEGIN*$ENDING").filter(Files::isRegularFile).sortedBy { it.name }
    }
}

/**
 * The content of a folder's files for the to-do list.
 *
 * @property changes the changes of all computers, in no particular order, possibly with duplicates.
 * @property checklist the lines of the team's own checklist.
 * @property problems a sentence for each file that could not be read.
 * @property isWhole whether all files could be read; one may be locked for a moment.
 */
class TodoFiles(
    val changes: List<TodoChange> = emptyList(),
    val checklist: List<String> = emptyList(),
    val problems: List<String> = emptyList(),
    val isWhole: Boolean = true,
)

/**
 * The beginning of the files' names. The computer's name follows, then possibly an addition of a sync program, such as
 * `badlog-todo-pit (conflicted copy).jsonl`.
 */
private const val BEGIN = "badlog-todo"
private const val ENDING = ".jsonl"
