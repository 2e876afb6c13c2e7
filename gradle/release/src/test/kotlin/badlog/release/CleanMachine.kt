package badlog.release

import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import java.io.File
import java.nio.file.Files
import java.util.concurrent.TimeUnit

/** The result of a program: its exit code and all of its output. */
internal class ProgramResult(val code: Int, val text: String)

/**
 * A machine with only [programs]. It has an empty environment, a PATH and a home folder of its own, and no network.
 *
 * @param folder an empty folder for its files.
 */
internal class CleanMachine(private val folder: File, programs: List<String>) {
    private val path = File(folder, "path")

    init {
        path.mkdirs()
        for (program in programs) Files.createSymbolicLink(File(path, File(program).name).toPath(), found(program).toPath().toRealPath())
    }

    /** Runs [command] in [workFolder]; [variables] are added to its environment. */
    fun run(command: List<String>, workFolder: File = folder, variables: Map<String, String> = emptyMap()): ProgramResult = run(process(command, workFolder, variables))

    /** Returns [command] as a process that is not started yet. */
    fun process(command: List<String>, workFolder: File = folder, variables: Map<String, String> = emptyMap()): ProcessBuilder {
        val builder = ProcessBuilder(WITHOUT_NETWORK + command).directory(workFolder)
        builder.environment().clear()
        builder.environment() += mapOf("PATH" to path.path, "HOME" to File(folder, "home").apply { mkdirs() }.path) + variables
        return builder
    }

    companion object {
        // A new namespace has no network; its loopback interface is brought up because some programs connect to themselves.
        private val WITHOUT_NETWORK = listOf(
            found("unshare").path, "--user", "--map-root-user", "--net", "--", "/bin/sh", "-c", "/sbin/ip link set lo up; exec \"\$@\"", "sh",
        )

        /** Enables a test if such a machine can be made. */
        val IF_POSSIBLE: EnabledOrReasonIf = {
            when {
                !PLATFORM.startsWith("linux") -> Enabled.disabled("clean machines are made on Linux only")
                !found("unshare").canExecute() -> Enabled.disabled("unshare is not installed")
                run(ProcessBuilder(WITHOUT_NETWORK + "true")).code != 0 -> Enabled.disabled("this system makes no namespace without a network")
                else -> Enabled.enabled
            }
        }
    }
}

/** Starts [builder], and waits for its end, at most [minutes]. */
internal fun run(builder: ProcessBuilder, minutes: Long = 15): ProgramResult {
    val output = File.createTempFile("output", ".txt")
    val process = builder.redirectErrorStream(true).redirectOutput(output).start()
    val hasEnded = process.waitFor(minutes, TimeUnit.MINUTES)
    if (!hasEnded) process.destroyForcibly().waitFor()
    val text = output.readText()
    output.delete()
    check(hasEnded) { "${builder.command().joinToString(" ")} has not ended after $minutes minutes: $text" }
    return ProgramResult(process.exitValue(), text)
}

/** Returns the file of [program], which is a path or on the PATH. */
internal fun found(program: String): File = if ('/' in program) {
    File(program)
} else {
    System.getenv("PATH").split(File.pathSeparator).map { File(it, program) }.firstOrNull { it.canExecute() } ?: File("/nowhere/$program")
}
