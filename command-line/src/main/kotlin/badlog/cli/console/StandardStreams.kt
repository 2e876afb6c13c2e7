package badlog.cli.console

import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.outputStream

/**
 * Makes `-` stand for the standard input among the logs, and for the standard output after `--out`. Logs are read more than once
 * and written atomically, so both are files while the program runs.
 *
 * @param input the standard input, read to its end if it is used.
 */
internal class StandardStreams(typed: List<String>, private val input: InputStream) : AutoCloseable {
    private var folder: Path? = null
    private var log: Path? = null
    private var result: Path? = null

    /** The arguments, with files in place of `-`. */
    val arguments: List<String> = withFiles(typed)

    /** The names of these files for people. */
    val names: Map<String, String>
        get() = listOfNotNull(log?.let { "$it" to "standard input" }, result?.let { "$it" to "standard output" }).toMap()

    /** Whether the standard output receives a result, so that nothing else may be printed there. */
    val hasResult: Boolean get() = result != null

    /** Passes the result, if there is one, to [sink]. */
    fun giveResult(sink: (Path) -> Unit) {
        result?.takeIf { it.exists() }?.let(sink)
    }

    override fun close() {
        for (file in listOf(log, result, folder)) file?.deleteIfExists()
    }

    private fun withFiles(typed: List<String>): List<String> {
        val replaced = typed.mapIndexed { index, word ->
            val before = typed.getOrNull(index - 1)
            when {
                word == "--out=-" || (word == "-" && before in OUT) -> word.removeSuffix("-") + resultFile()
                word == "-" && before !in TEXTS -> logFile().toString()
                else -> word
            }
        }
        val isBesideLog = log != null && typed.none { it in OUT || it.startsWith("--out=") }
        return if (isBesideLog && typed.first() in WRITERS) replaced + listOf("--out", resultFile().toString()) else replaced
    }

    private fun resultFile(): Path = result ?: (ownFolder() / "badlog.stdout").also { result = it }

    private fun logFile(): Path = log ?: (ownFolder() / "stdin").also { file ->
        log = file
        file.outputStream().use(input::copyTo)
    }

    private fun ownFolder(): Path = folder ?: Files.createTempDirectory("badlog").also { folder = it }

    private companion object {
        val OUT = setOf("-o", "--out")

        /** Options after which `-` is an ordinary text. */
        val TEXTS = setOf("--around")

        /** Subcommands that would write beside the log. */
        val WRITERS = setOf("convert", "cut", "export", "recover")
    }
}
