package badlog.cli.command

import badlog.catalog.match.MatchMaker
import badlog.cli.console.Console
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.files.LogFile
import badlog.files.UnreadableFileException
import badlog.files.reading
import badlog.signals.match.files.MatchManifest
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.name

/** The current logs below [paths], for evaluating all of them at once, and reporting each result afterwards. */
internal class LogFiles(paths: List<Path>, console: Console, opensMatches: Boolean = false) {
    private val found = console.searching().use { LogSearch(opensMatches, it::next).find(paths) }
    private val failures = LinkedHashMap<LogInput, UnreadableFileException>()
    private val fileOf = LinkedHashMap<LogInput, LogFile>()

    init {
        for (input in found.inputs) {
            try {
                fileOf[input] = input.seen ?: reading(input.file) { fileOf(input.file) }
            } catch (e: UnreadableFileException) {
                failures[input] = e
            }
        }
    }

    /** Returns the current state of [file], and of the logs that a `match.json` names. */
    private fun fileOf(file: Path): LogFile {
        val logs = if (file.name == MatchManifest.NAME) MatchMaker.filesOf(file) else emptySet()
        return logs.map(LogFile::of).fold(LogFile.of(file)) { all, log ->
            all.copy(size = all.size + log.size, modified = maxOf(all.modified, log.modified))
        }
    }

    /** The existing logs, in order. */
    val files: List<LogFile> get() = fileOf.values.toList()

    /** Returns the path of [file], one of [files], relative to the folder in which it was found, with slashes. */
    fun nameOf(file: LogFile): String = names.getValue(file)

    private val names: Map<LogFile, String> by lazy {
        fileOf.entries.associate { (input, file) -> file to input.relativePath.invariantSeparatorsPathString }
    }

    /** Reports files that cannot be read to [outcomes], and the others with [report], all in order. */
    fun report(outcomes: Outcomes, report: (LogInput, LogFile) -> Unit) {
        for (failure in found.failures) outcomes.failed(failure.file, failure.message)
        for (input in found.inputs) {
            val file = fileOf[input]
            if (file == null) outcomes.failed(input.file, failures.getValue(input).message) else report(input, file)
        }
    }
}
