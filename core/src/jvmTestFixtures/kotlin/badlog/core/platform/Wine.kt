package badlog.core.platform

import java.io.File

/**
 * Wine with its own drive C: in the working directory. Closing it ends all of its processes, but leaves the drive. The drive links to this
 * machine's files, so do not follow links when you remove it.
 */
internal class Wine : AutoCloseable {
    /** Quietly, without a browser, .NET and a debugger, and with file names in UTF-8. */
    private val environment: Map<String, String> = mapOf(
        "WINEPREFIX" to File("wine").absolutePath,
        "WINEDEBUG" to "-all",
        "WINEDLLOVERRIDES" to "mscoree=;mshtml=;winedbg.exe=",
        "LC_ALL" to "C.UTF-8",
    )

    init {
        // The first start creates the drive, and prints many lines.
        LimitedRun.of(listOf("wine", "wineboot", "-i"), environment)
    }

    /** Runs [command], which begins with `wine`, in [folder], with [variables] added to its environment. */
    fun run(
        command: List<String>,
        variables: Map<String, String> = emptyMap(),
        folder: File = File("."),
        minutes: Long = LimitedRun.LIMIT_MINUTES,
    ): LimitedRun = try {
        LimitedRun.of(command, environment + variables, folder, minutes = minutes)
    } catch (e: IllegalStateException) {
        // A program of Windows is not a child of the one that started it.
        close()
        throw e
    }

    /** Returns [command], which begins with `wine`, as a process that is not started yet. */
    fun process(command: List<String>, variables: Map<String, String>): ProcessBuilder =
        ProcessBuilder(command).also { it.environment() += environment + variables }

    override fun close() {
        LimitedRun.of(listOf("wineserver", "-k"), environment)
    }
}
