package badlog.report.hook

import badlog.analysis.periodicTimes
import badlog.analysis.resampled
import badlog.bag.BagHeader
import badlog.bag.BagTopic
import badlog.bag.BagValue
import badlog.bag.headerText
import badlog.recording.Recording
import badlog.rules.HookCommand
import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicReference
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Runs a program of the user's for recordings; `docs/hooks.md` has what it gets and what it may return. Safe for several threads.
 *
 * What runs is [command] alone, word by word and without a shell. Nothing that stands in a log becomes part of it. It is to be
 * given by the person who starts the program, never by a file that came with the logs.
 *
 * @property command the program and its arguments; in an argument `{header}` becomes the path of the header's file.
 * @property timeLimit how long the program may take for one recording before it and all it started are killed.
 * @property name what to call it; usually the script, or the program where no script is among its arguments.
 * @property folder where it runs; null for where this program runs.
 */
public class HookRunner(
    public val command: List<String>,
    public val timeLimit: Duration = DEFAULT_TIME_LIMIT,
    public val name: String = nameOf(command),
    public val folder: Path? = null,
) {
    init {
        require(command.isNotEmpty()) { "The command of the hook is empty." }
        require(timeLimit.isPositive()) { "The time limit of a hook must be above 0, not $timeLimit." }
    }

    /**
     * Runs the program for [recording], read with its samples. One without rows, as a WPILOG, is given in rows of 20 ms, each with
     * the last values until then.
     *
     * @throws HookException when it cannot be started, takes too long, fails, or returns something else than it has to.
     * @throws InterruptedException when the thread was interrupted; the program is then killed.
     */
    public fun run(recording: Recording): HookResult {
        val header = try {
            Files.createTempFile("badlog-header-", ".json")
        } catch (e: IOException) {
            throw HookException("No temporary file can be written for the hook: ${e.message}.", e)
        }
        val running = AtomicReference<HookRun>()
        fun end() {
            try {
                running.get()?.close()
            } finally {
                header.toFile().delete()
            }
        }
        try {
            return withShutdownHook(::end) {
                val rows = inRows(recording)
                Files.writeString(header, headerOf(rows))
                HookRun(start(header), rows, timeLimit).also(running::set).result()
            }
        } catch (e: HookException) {
            throw e
        } catch (e: IOException) {
            throw HookException("The program “${command[0]}” cannot be run: ${e.message}.", e)
        } finally {
            end()
        }
    }

    private fun start(header: Path): Process = try {
        ProcessBuilder(command.map { it.replace("{header}", header.toString()) }).apply {
            environment()["BADLOG_HEADER"] = header.toString()
            directory(folder?.toFile())
        }.start()
    } catch (e: IOException) {
        throw HookException(whyNotStarted(e.message.orEmpty()), e)
    }

    private fun whyNotStarted(message: String): String {
        val program = command[0]
        val reason = ERROR_OF_SYSTEM.find(message)?.let { " (${it.groupValues[1]})" }.orEmpty()
        val file = folder?.toFile()?.resolve(program) ?: File(program)
        return when {
            folder != null && !Files.isDirectory(folder) -> "The folder of the hook, “$folder”, does not exist."

            file.isFile ->
                "The file “$program” cannot be run as a program$reason; name what runs it, as in “python3 $program”, " +
                    "or allow it by chmod +x."

            else -> "The program “$program” cannot be started$reason; install it, or add its folder to the PATH."
        }
    }

    public companion object {
        /** How long a program may take where nobody says otherwise. */
        public val DEFAULT_TIME_LIMIT: Duration = 30.seconds

        /** The program of [hook], which a file of rules in [folder] names. */
        public fun of(hook: HookCommand, folder: Path?): HookRunner =
            HookRunner(hook.command, hook.timeLimit ?: DEFAULT_TIME_LIMIT, hook.name ?: nameOf(hook.command), folder)

        // The first argument that looks like a file's name is the script, as in `python3 -u tools/analyze.py`.
        private fun nameOf(command: List<String>): String {
            val script = command.drop(1).firstOrNull { !it.startsWith("-") && '.' in it && ' ' !in it && '{' !in it }
            return (script ?: command[0]).substringAfterLast('/').substringAfterLast('\\')
        }

        /** As in `Cannot run program "a.py": error=13, Permission denied` or `CreateProcess error=2, …`. */
        private val ERROR_OF_SYSTEM = Regex("error=\\d+, (.*)")

        /** The line of a bag, or one that says as much of another file. */
        private fun headerOf(recording: Recording): String = recording.headerLine ?: headerText(
            BagHeader(
                recording.topics.map { BagTopic(it.name, it.unit, it.attributes) },
                recording.values.map { BagValue(it) },
            ),
        )

        /** A loop of the robot. */
        private const val PERIOD = 0.02

        private fun inRows(recording: Recording): Recording =
            if (recording.topics.any { it.times != null }) resampled(recording, periodicTimes(recording, PERIOD)) else recording
    }
}
