package badlog.lib

import badlog.robots.ChildRobot
import java.io.File

/** The class path of a robot: no test library, no JSON library. */
private val classpath = System.getProperty("badlog.shipped") + File.pathSeparator + System.getProperty("badlog.robots")

/** The command that runs [ChildRobot] with [arguments]. */
fun childCommand(arguments: List<String>, jvmOptions: List<String> = emptyList()): List<String> {
    val java = File(System.getProperty("java.home"), "bin/java").path
    val options = listOf("-XX:+UseSerialGC", "-Xmx64m", "-XX:TieredStopAtLevel=1") + jvmOptions
    return listOf(java) + options + listOf("-cp", classpath, ChildRobot::class.java.name) + arguments
}

/** Runs [command], and returns its output with its exit code. */
fun run(command: List<String>): Pair<Int, String> {
    val process = ProcessBuilder(command).redirectErrorStream(true).start()
    val output = process.inputStream.readBytes().decodeToString()
    return process.waitFor() to output
}

fun canRun(program: String): Boolean = System.getenv("PATH").orEmpty().split(File.pathSeparator).any { File(it, program).canExecute() }
