package badlog.cli.plugin

import java.io.File
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** The folder `lib` of the program as it is installed. */
internal val LIBRARIES: Path = Path.of("../libraries").toAbsolutePath().normalize()

internal fun jarsIn(folder: Path): List<Path> = folder.listDirectoryEntries().filter { it.extension == "jar" }.sorted()

/** The names of the jars in [folder], without their versions. */
internal fun namesIn(folder: Path): List<String> = jarsIn(folder).map { it.name.replace(Regex("(-\\d[^-]*.*)?\\.jar$"), "") }.sorted()

/** The command line that starts the installed program with [arguments]. */
internal fun javaCommand(vararg arguments: String): List<String> = javaCommand(jarsIn(LIBRARIES), arguments.toList())

/** The same with [jars] as its class path. */
internal fun javaCommand(jars: List<Path>, arguments: List<String>): List<String> {
    val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
    return listOf(java, "-cp", jars.joinToString(File.pathSeparator), "badlog.cli.MainKt") + arguments
}
