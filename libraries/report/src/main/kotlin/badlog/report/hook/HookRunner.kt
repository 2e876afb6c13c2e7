package badlog.report.hook

import badlog.core.analysis.periodicTimes
import badlog.core.analysis.resampled
import badlog.core.bag.BagHeader
import badlog.core.bag.BagTopic
import badlog.core.bag.BagValue
import badlog.core.bag.headerText
import badlog.core.recording.Recording
import badlog.files.withShutdownHook
import badlog.rules.HookCommand
import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicReference
import kotlin.time.Duration
import kotlin.time.Duration.Companion.seconds

/**
 * Runs a program of the user for recordings; `docs/hooks.md` describes its input and output. Thread-safe.
 *
 * Only [command] runs, word by word and without a shell. Nothing in a log becomes part of it. It must come from the person who
 * starts the program, never from a file that came with the logs.
 *
 * @property command the program and its arguments; in an argument, `{header}` is replaced by the path of the header's file.
 * @property timeLimit the time that the program may take for one recording before it and all its children are killed.
 * @property name its name; usually the script, or the program if no script is among its arguments.
 * @property folder its working directory; null for this program's own.
 * @param nanos returns the time in ns since an arbitrary moment, for measuring [timeLimit].
 */
class HookRunner internal constructor(
    val command: List<String>,
    val timeLimit: Duration,
    val name: String,
    val folder: Path?,
    private val nanos: () -> Long,
) {
    constructor(command: List<String>, timeLimit: Duration = DEFAULT_TIME_LIMIT, name: String = nameOf(command), folder: Path? = null) :
        this(command, timeLimit, name, folder, System::nanoTime)

    init {
        require(command.isNotEmpty()) { "The command of the hook is empty." }
        require(timeLimit.isPositive()) { "The time limit of a hook must be above 0, not $timeLimit." }
    }

    /**
     * Runs the program for [recording], which must have been read with its samples. A recording without rows, such as a WPILOG, is
     * passed in rows of 20 ms, each with the last values up to then.
     *
     * @throws HookException if it cannot be started, takes too long, fails, or returns something invalid.
     * @throws InterruptedException if the thread was interrupted; the program is then killed.
     */
    fun run(recording: Recording): HookResult {
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
                HookRun(start(header), rows, timeLimit, nanos).also(running::set).result()
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
                "The file “$program” cannot be run as a program$reason; name the program that runs it, as in “python3 $program”, " +
                    "or make it executable with chmod +x."

            else -> "The program “$program” cannot be started$reason; install it, or add its folder to the PATH."
        }
    }

    companion object {
        val DEFAULT_TIME_LIMIT: Duration = 30.seconds

        /** Returns the runner of [hook], which a file of rules in [folder] names. */
        fun of(hook: HookCommand, folder: Path?): HookRunner =
            HookRunner(hook.command, hook.timeLimit ?: DEFAULT_TIME_LIMIT, hook.name ?: nameOf(hook.command), folder)

        // Returns the name: the first argument that looks like a file name is the script, as in `python3 -u tools/analyze.py`.
        private fun nameOf(command: List<String>): String {
            val script = command.drop(1).firstOrNull { !it.startsWith("-") && '.' in it && ' ' !in it && '{' !in it }
            return (script ?: command[0]).substringAfterLast('/').substringAfterLast('\\')
        }

        /** As in `Cannot run program "a.py": error=13, Permission denied` or `CreateProcess error=2, …`. */
        private val ERROR_OF_SYSTEM = Regex("error=\\d+, (.*)")

        /** Returns the header line of a bag, or an equivalent one for another file. */
        private fun headerOf(recording: Recording): String = recording.headerLine ?: headerText(
            BagHeader(
                recording.topics.map { BagTopic(it.name, it.unit, it.attributes) },
                recording.values.map { BagValue(it) },
            ),
        )

        /** The period of a robot's loop, in s. */
        private const val PERIOD = 0.02

        private fun inRows(recording: Recording): Recording =
            if (recording.topics.any { it.times != null }) resampled(recording, periodicTimes(recording, PERIOD)) else recording
    }
}
