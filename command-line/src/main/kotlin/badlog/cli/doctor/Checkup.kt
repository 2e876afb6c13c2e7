package badlog.cli.doctor

import badlog.cli.computer.Computer
import badlog.cli.text.counted
import badlog.cli.text.sizeText
import badlog.exporter.BADLOG_VERSION
import badlog.fetch.RobotAddress
import badlog.fetch.answering
import badlog.files.OwletSearch
import badlog.files.UserFolders
import badlog.files.terminal.browserCommand
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.isRegularFile

/** The result of a check. */
internal enum class CheckState(val word: String) {
    /** Everything is fine. */
    OK("ok"),

    /** Something that only some people need is missing. */
    MISSING("missing"),

    /** Something that was requested, or that badlog needs, does not work. */
    ERROR("error"),
}

/**
 * A line of a check-up.
 *
 * @property name the subject of the check.
 * @property text the result, with advice unless it is [CheckState.OK].
 */
internal class CheckFinding(val name: String, val state: CheckState, val text: String)

/**
 * Checks the parts of [computer] that badlog uses.
 *
 * @param addresses the addresses at which a robot may answer; null to check no robot.
 * @param patience the time that a robot may take to answer.
 */
internal class Checkup(private val computer: Computer, private val addresses: List<RobotAddress>?, private val patience: Duration) {
    /** Returns one finding for each check. */
    fun findings(): List<CheckFinding> = listOf(
        CheckFinding("badlog", CheckState.OK, BADLOG_VERSION),
        java(),
        browser(),
        window(),
        owlet(),
        folder("settings", computer.folders.settings, "yours, badlog never deletes it"),
        folder("cache", computer.folders.cache, "safe to delete"),
    ) + listOfNotNull(answers(), robot())

    private fun java(): CheckFinding {
        val memory = sizeText(Runtime.getRuntime().maxMemory())
        return CheckFinding("Java", CheckState.OK, "${Runtime.version()} in ${System.getProperty("java.home")}, may use $memory of memory")
    }

    private fun browser(): CheckFinding {
        val command = browserCommand(computer.system).first()
        val program = computer.program(command)
        return when {
            program != null -> CheckFinding("browser", CheckState.OK, "opened by $program")

            else -> CheckFinding(
                "browser",
                CheckState.MISSING,
                "$command is not on the PATH, so badlog cannot open pages; install xdg-utils, or open pages yourself",
            )
        }
    }

    private fun window(): CheckFinding = when (val window = computer.window()) {
        null -> CheckFinding(
            "window",
            CheckState.MISSING,
            "not installed, so “badlog open” shows pages; install it, or set ${Computer.WINDOW} to its program",
        )

        else -> CheckFinding("window", CheckState.OK, "$window")
    }

    private fun owlet(): CheckFinding = when (val owlet = OwletSearch(computer.system, computer.user, computer.variable).any) {
        null -> CheckFinding(
            "owlet",
            CheckState.MISSING,
            "not found, so .hoot logs cannot be read; AdvantageScope downloads it, or get it from CTRE, if you have such logs",
        )

        else -> CheckFinding("owlet", CheckState.OK, "$owlet")
    }

    /** Returns the answers to questions, where they are not in the folder of all that is cached. */
    private fun answers(): CheckFinding? {
        val answers = UserFolders.ofSystem(computer.system, computer.user, computer.variable).answers
        return if (answers.startsWith(computer.folders.cache)) null else folder("answers", answers, "safe to delete")
    }

    private fun folder(name: String, folder: Path, remark: String): CheckFinding {
        if (!Files.exists(folder)) {
            val parent = generateSequence(folder.toAbsolutePath()) { it.parent }.first { Files.exists(it) }
            if (!Files.isWritable(parent)) return unwritable(name, folder)
            return CheckFinding(name, CheckState.OK, "$folder, not used yet")
        }
        if (!Files.isDirectory(folder) || !Files.isWritable(folder)) return unwritable(name, folder)
        return try {
            val sizes = Files.walk(folder).use { files -> files.filter { it.isRegularFile() }.mapToLong { Files.size(it) }.toArray() }
            CheckFinding(name, CheckState.OK, "$folder, ${counted(sizes.size.toLong(), "file")}, ${sizeText(sizes.sum())}; $remark")
        } catch (_: IOException) {
            unwritable(name, folder)
        } catch (_: UncheckedIOException) {
            unwritable(name, folder)
        }
    }

    private fun unwritable(name: String, folder: Path) =
        CheckFinding(name, CheckState.ERROR, "$folder cannot be written; check its permissions")

    private fun robot(): CheckFinding? {
        val wanted = addresses ?: return null
        val names = wanted.joinToString { it.toString() }
        return when (val found = answering(wanted, patience).firstOrNull()) {
            null -> CheckFinding("robot", CheckState.ERROR, "does not answer at $names; connect to its network or by USB")
            else -> CheckFinding("robot", CheckState.OK, "answers at $found")
        }
    }
}
