package badlog.window.todo

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.LogEntry
import badlog.catalog.todo.TodoFiles
import badlog.catalog.todo.TodoFolder
import badlog.catalog.todo.newChange
import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.files.writeAtomically
import badlog.rules.folder.FolderRules
import badlog.signals.match.localSecondOf
import badlog.viewer.panel.folder.ListedTodo
import badlog.viewer.state.FolderRequest
import badlog.viewer.todo.CheckedLine
import badlog.viewer.todo.FaultTask
import badlog.viewer.todo.FoundFault
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoLog
import badlog.viewer.todo.TodoSubject
import badlog.viewer.todo.recentOf
import badlog.viewer.todo.toPage
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.folder.Library
import badlog.window.settings.SettingsStore
import badlog.window.state.StateHolder
import badlog.window.task.FileWrites
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import badlog.window.task.openAction
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.io.IOException
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

/**
 * The team's to-do list beside the logs of the open folder. Use it only on the window's thread. Other laptops may change the list as well.
 */
internal class FolderTodo(
    private val scope: CoroutineScope,
    private val library: Library,
    private val settings: SettingsStore,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
    private val writes: FileWrites,
) : StateHolder<TodoState>(TodoState()) {
    /** The name of the person who changes the list here. */
    val author: String get() = settings.state.author.ifBlank { System.getProperty("user.name").orEmpty() }.ifBlank { "somebody" }

    /** The list as its panels show it. */
    val listed: ListedTodo
        get() = with(state) { ListedTodo(list, checklist, folder != null, files.checklist.isNotEmpty(), author) }

    /** Follows the open folder, until cancelled. */
    suspend fun run() = snapshotFlow { library.state.folder }.collectLatest { path ->
        change { TodoState() }
        if (path == null) return@collectLatest
        val folder = withContext(Dispatchers.IO) { TodoFolder(path) }
        change { copy(folder = folder) }
        coroutineScope {
            launch { followFiles(folder, path) }
            launch { followLogs() }
        }
    }

    private suspend fun followFiles(folder: TodoFolder, path: Path) {
        var last: List<Any>? = null
        var reported = emptyList<String>()
        while (true) {
            val stamp = withContext(Dispatchers.IO) { folder.stamp() }
            if (stamp != last) {
                val (read, ofRules) = withContext(Dispatchers.IO) { readIn(folder, path) }
                change { reading(read, ofRules) }
                (read.problems - reported.toSet()).forEach(notices::complain)
                reported = read.problems
                last = stamp.takeIf { read.isWhole }
            }
            delay(PERIOD)
        }
    }

    private fun readIn(folder: TodoFolder, path: Path): Pair<TodoFiles, List<String>> = try {
        folder.read()
    } catch (e: IOException) {
        TodoFiles(problems = listOf(e.message.orEmpty()), isWhole = false)
    } to FolderRules.of(path.resolve("any"), path).rules.checklist

    private suspend fun followLogs() {
        val known = HashMap<Pair<LogFile, Int?>, List<FoundFault>>()
        snapshotFlow { examinedLogs() to state.list.rules }.collectLatest { (entries, rules) ->
            val examined = library.examined
            val logs = withContext(Dispatchers.IO) { foundLogs(entries, rules, known, examined) }
            if (logs != state.logs) change { copy(logs = logs) }
        }
    }

    private fun examinedLogs() = library.state.ofRobots.filter { !it.isGray && it.found?.rules != null }

    /** Records that [by] did [deed] to [subject]: at once on the list, and soon in the file. */
    fun write(subject: TodoSubject, deed: TodoDeed, by: String = author) {
        val folder = state.folder ?: return notices.complain("Open a folder of logs first; the list is kept beside them.")
        val made = newChange(subject, deed, by, lastLog(), state.files.changes + state.written)
        change { copy(written = written + made) }
        scope.launch(start = CoroutineStart.UNDISPATCHED) {
            try {
                writes.write { folder.append(made) }
            } catch (e: IOException) {
                change { copy(written = written - made) }
                notices.complain(e.message.orEmpty())
            }
        }
    }

    /** Returns the log that began last, including logs that rules have not examined yet; null if none is known. */
    private fun lastLog(): TodoLog? {
        val now = wallClock()
        return library.state.ofRobots.map { foundLog(it, now) }.filter { it.isDated }.maxByOrNull { it.second }
    }

    /** Remembers that the person at this computer is [name], unless a person is known already. */
    private fun rememberAuthor(name: String) {
        if (name.isNotBlank() && name != author && settings.state.author.isBlank()) settings.change { copy(author = name.trim()) }
    }

    /** Performs [request]. */
    fun perform(request: FolderRequest.WriteTodo) {
        request.by?.let(::rememberAuthor)
        write(request.subject, request.deed, request.by ?: author)
    }

    /** Asks for a file, and writes the list and the checklist to it as a page. */
    fun savePage() {
        val folder = library.state.folder ?: return notices.complain("Open a folder of logs first; the list is kept beside them.")
        val file = askToWrite(files, notices, "Save the list", folder, "to-do", ".html") ?: return
        val page = state.list.toPage("${folder.fileName ?: folder}", state.lines)
        tasks.run("Saving ${file.fileName}", { writeAtomically(file) { it.write(page.encodeToByteArray()) } }) {
            notices.say("Saved $file.", openAction(file, scope, notices))
        }
    }

    private companion object {
        val PERIOD = 2.seconds
    }
}

/** The names of the rules with findings on the list. */
private val TodoList.rules: Set<String> get() = (open + done).mapNotNullTo(HashSet()) { (it.task as? FaultTask)?.rule }

private fun wallClock() = localSecondOf(System.currentTimeMillis() / MILLIS)

private const val MILLIS = 1000L

private fun foundLog(entry: LogEntry, now: Long) = TodoLog.of(entry.fileName, entry.summary.match, entry.summary.date, now)

/**
 * Returns the logs of [entries] for the list. Findings of a log are read only if they may matter: [rules] are on the list, or the log is
 * one of the last and has an error.
 *
 * @param known the findings that were read before, by the file and the key of its findings.
 */
private fun foundLogs(
    entries: List<LogEntry>,
    rules: Set<String>,
    known: MutableMap<Pair<LogFile, Int?>, List<FoundFault>>,
    examined: (LogEntry) -> ExaminedLog?,
): List<TodoLog> {
    val now = wallClock()
    val logs = entries.map { foundLog(it, now) }
    val recent = recentOf(logs).toSet()
    return entries.zip(logs).map { (entry, log) ->
        val isWanted = entry.found?.rules.orEmpty().any { it.name in rules || (log in recent && it.severity == Severity.ERROR) }
        if (!isWanted) return@map log
        val key = entry.source to entry.found?.key
        val faults = known[key] ?: examined(entry)?.findings?.map(FoundFault::of)?.also { known[key] = it }
        log.copy(faults = faults.orEmpty())
    }
}

/**
 * The to-do list of the open folder, as the window knows it.
 *
 * @property folder the folder that stores it; null while no folder is open.
 * @property files the content that was read last.
 * @property written the changes by this window since then.
 * @property logs the logs of the folder, with their findings.
 * @property ofRules the lines of the checklist that come from the folder's rules.
 */
internal data class TodoState(
    val folder: TodoFolder? = null,
    val files: TodoFiles = TodoFiles(),
    val written: List<TodoChange> = emptyList(),
    val logs: List<TodoLog> = emptyList(),
    val ofRules: List<String> = emptyList(),
) {
    /** The list. */
    val list: TodoList by lazy { TodoList.of(files.changes + written, logs) }

    /** The lines of the checklist: the lines of the rules, then the team's own. */
    val lines: List<String> get() = (ofRules + files.checklist).distinct()

    /** The checklist before the next match. */
    val checklist: List<CheckedLine> by lazy { list.checklist(lines) }

    /** Returns the state with the [read] content, and without the written changes that it contains. */
    fun reading(read: TodoFiles, ofRules: List<String>): TodoState {
        val ids = read.changes.mapTo(HashSet()) { it.id }
        return copy(files = read, ofRules = ofRules, written = written.filter { it.id !in ids })
    }
}
