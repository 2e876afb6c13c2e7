package badlog.lib

import badlog.core.platform.LimitedRun
import badlog.core.platform.Wine
import java.io.File

/**
 * The Java of another machine, in an emulator.
 *
 * @param property the system property with the command that starts it, its words separated by line ends; the build sets it.
 * @param separator what separates the parts of its class path.
 * @property listsDisks whether its programs can list folders on a disk. The 32-bit C library in an emulator refuses the 64-bit positions in
 *   the folders of a 64-bit system; a file system in memory has small ones.
 */
internal class Platform private constructor(val name: String, private val property: String, private val separator: String, val listsDisks: Boolean = true) {
    private val command = System.getProperty(property).orEmpty().lines().filter { it.isNotEmpty() }

    val isMissing: Boolean get() = command.isEmpty()

    /** The reason why it is missing; empty if it is there. */
    val missing: String = System.getProperty("$property.missing").orEmpty()

    /** Runs [program] with the class path of a robot. */
    fun runRobot(wine: () -> Wine, program: Class<*>, vararg arguments: String): LimitedRun {
        val classpath = listOf("badlog.shipped", "badlog.robots").flatMap { System.getProperty(it).split(File.pathSeparator) }
        return run(wine, classpath, listOf(program.name) + arguments, File("."), LimitedRun.LIMIT_MINUTES)
    }

    /** Runs Java with [arguments] in [folder], for at most [minutes]. The first argument is its main class. */
    fun run(wine: () -> Wine, classpath: List<String>, arguments: List<String>, folder: File, minutes: Long): LimitedRun {
        val line = command + listOf("-cp", classpath.joinToString(separator)) + arguments
        return if (command.first() == "wine") {
            wine().run(line, folder = folder, minutes = minutes)
        } else {
            LimitedRun.of(line, ENVIRONMENT, folder, minutes = minutes)
        }
    }

    companion object {
        private val ENVIRONMENT = mapOf("LC_ALL" to "C.UTF-8")

        val all: List<Platform> = listOf(
            Platform("Windows (Wine)", "badlog.platforms.windows", ";"),
            Platform("64-bit ARM (qemu)", "badlog.platforms.arm64", ":"),
            Platform("Java 25 on 64-bit ARM, as on Systemcore (qemu)", "badlog.platforms.systemcore", ":"),
            Platform("32-bit ARM (qemu)", "badlog.platforms.armhf", ":", listsDisks = false),
        )
    }
}
