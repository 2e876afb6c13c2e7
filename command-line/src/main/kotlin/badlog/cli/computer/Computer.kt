package badlog.cli.computer

import badlog.file.UserFolders
import badlog.file.programOnPath
import badlog.terminal.startProgram
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * What this computer has for badlog beside the program itself.
 *
 * @property system the name of its system, as Java has it.
 * @property user the folder of the user.
 * @property variable the values of its environment.
 * @property folders where badlog keeps what is the user's own.
 * @property start starts a program with a window, and says whether that worked.
 */
internal class Computer(
    val system: String = System.getProperty("os.name"),
    val user: Path = Path.of(System.getProperty("user.home")),
    val variable: (String) -> String? = System::getenv,
    val folders: UserFolders = UserFolders.ofSystem(system, user, variable),
    val start: (List<String>) -> Boolean = ::startProgram,
) {
    /** Where the program [name] is on the PATH; null when it is not there. */
    fun program(name: String): Path? = programOnPath(name, variable("PATH"))

    /** Where the window is installed, or what [WINDOW] names; null when it is in none of the places in which its installers put it. */
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
        // Whoever set the variable hears that there is no window.
        null
    }

    companion object {
        /** The variable that names the window's program, for one that was unpacked anywhere. */
        const val WINDOW = "BADLOG_WINDOW"
    }
}
