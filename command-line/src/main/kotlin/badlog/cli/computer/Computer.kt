package badlog.cli.computer

import badlog.files.UserFolders
import badlog.files.programOnPath
import badlog.files.terminal.startProgram
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * The parts of this computer that badlog uses besides the program itself.
 *
 * @property system the name of its system in Java.
 * @property user the user's home folder.
 * @property variable returns values of environment variables.
 * @property folders returns the folders for the user's own files.
 * @property start starts a program with a window, and returns whether that worked.
 */
internal class Computer(
    val system: String = System.getProperty("os.name"),
    val user: Path = Path.of(System.getProperty("user.home")),
    val variable: (String) -> String? = System::getenv,
    val folders: UserFolders = UserFolders.ofSystem(system, user, variable),
    val start: (List<String>) -> Boolean = ::startProgram,
) {
    /** Returns the path of the program [name] on the PATH; null if it is not there. */
    fun program(name: String): Path? = programOnPath(name, variable("PATH"))

    /**
     * Returns the program of the window: the one that [WINDOW] names, or else the installed one. Null if there is none at the places used by
     * its installers.
     */
    fun window(): Path? = (listOf(variable(WINDOW)) + installed()).firstNotNullOfOrNull { it?.let(::executable) }

    private fun installed(): List<String> = when {
        system.startsWith("Windows") -> listOf("LOCALAPPDATA", "ProgramFiles").mapNotNull { folder ->
            variable(folder)?.let { "$it\\badlog\\badlog.exe" }
        }

        system.startsWith("Mac") -> listOf("/Applications", "$user/Applications").map { "$it/badlog.app/Contents/MacOS/badlog" }

        else -> listOf("/opt/badlog/bin/badlog")
    }

    private fun executable(file: String): Path? = try {
        Path.of(file).takeIf { Files.isRegularFile(it) && Files.isExecutable(it) }
    } catch (_: InvalidPathException) {
        // If the variable is wrong, the window counts as missing.
        null
    }

    companion object {
        /** The environment variable with the window's program, for a copy unpacked elsewhere. */
        const val WINDOW = "BADLOG_WINDOW"
    }
}
