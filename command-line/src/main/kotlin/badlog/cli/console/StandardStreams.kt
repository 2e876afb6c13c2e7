package badlog.cli.console

import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.outputStream

/**
 * Lets `-` stand for the standard input among the logs, and after `--out` for the standard output. Logs are read more than once and
 * written whole or not at all, so both are files while the program runs.
 *
 * @param input the standard input, read to its end where it is asked for.
 */
internal class StandardStreams(typed: List<String>, private val input: InputStream) : AutoCloseable {
    private var folder: Path? = null
    private var log: Path? = null
    private var result: Path? = null

    /** What was typed, with files in place of `-`. */
    val arguments: List<String> = withFiles(typed)

    /** How the files are to be called in front of people. */
    val names: Map<String, String> get() = listOfNotNull(log, result).associate { it.toString() to "-" }

    /** Whether the standard output gets a result, so that nothing may be said there. */
    val hasResult: Boolean get() = result != null

    /** Gives the result, where there is one, to [sink]. */
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

    private fun resultFile(): Path = result ?: (ownFolder() / "stdout").also { result = it }

    private fun logFile(): Path = log ?: (ownFolder() / "stdin").also { file ->
        log = file
        file.outputStream().use(input::copyTo)
    }

    private fun ownFolder(): Path = folder ?: Files.createTempDirectory("badlog").also { folder = it }

    private companion object {
        val OUT = setOf("-o", "--out")

        /** Options after which `-` is a text like any other. */
        val TEXTS = setOf("--around")

        /** Sub-commands that would write beside the log. */
        val WRITERS = setOf("convert", "cut", "export", "recover")
    }
}
