package badlog.cli.command

import badlog.cli.console.Console
import badlog.cli.input.LogInput
import badlog.cli.input.LogSearch
import badlog.file.LogFile
import badlog.file.UnreadableFileException
import badlog.file.reading
import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString

/** The logs below [paths] as they are now, to ask all of them at once, and to report each result afterwards. */
internal class LogFiles(paths: List<Path>, console: Console) {
    private val found = console.searching().use { LogSearch(it::next).find(paths) }
    private val failures = LinkedHashMap<LogInput, UnreadableFileException>()
    private val fileOf = LinkedHashMap<LogInput, LogFile>()

    init {
        for (input in found.inputs) {
            try {
                fileOf[input] = input.seen ?: reading(input.file) { LogFile.of(input.file) }
            } catch (e: UnreadableFileException) {
                failures[input] = e
            }
        }
    }

    /** Those that are there, in their order. */
    val files: List<LogFile> get() = fileOf.values.toList()

    /** What [file], one of [files], is called below the folder in which it was found, with slashes. */
    fun nameOf(file: LogFile): String = names.getValue(file)

    private val names: Map<LogFile, String> by lazy {
        fileOf.entries.associate { (input, file) -> file to input.relativePath.invariantSeparatorsPathString }
    }

    /** Reports to [outcomes] what cannot be read, and lets [report] report the rest, all in their order. */
    fun report(outcomes: Outcomes, report: (LogInput, LogFile) -> Unit) {
        for (failure in found.failures) outcomes.failed(failure.file, failure.message)
        for (input in found.inputs) {
            val file = fileOf[input]
            if (file == null) outcomes.failed(input.file, failures.getValue(input).message) else report(input, file)
        }
    }
}
