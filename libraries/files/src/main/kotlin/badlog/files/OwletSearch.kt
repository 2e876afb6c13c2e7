package badlog.files

import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/**
 * Finds CTRE's program that converts a `.hoot`, in the places where teams have it. The environment variable [SETTING] may name its file or
 * folder. It may be in the folder into which AdvantageScope downloads one for each version of the format, beside AdvantageScope, or on the
 * PATH.
 *
 * @param system the name of the operating system.
 * @param user the user's home.
 * @param variable returns the value of an environment variable.
 */
public class OwletSearch(
    private val system: String = System.getProperty("os.name"),
    private val user: Path = Path.of(System.getProperty("user.home")),
    private val variable: (String) -> String? = System::getenv,
) {
    private class Converter(val file: Path, val version: List<Int>, val compliancy: Int)

    private val named: Path? by lazy { variable(SETTING)?.takeIf { it.isNotBlank() }?.let(::pathOf) }
    private val onPath: Path? by lazy { programOnPath(NAME, variable("PATH")) }

    private val converters: List<Converter> by lazy { folders().flatMap(::convertersIn) }

    /** A program that converts some logs; null if there is none. */
    public val any: Path? get() = named?.takeIf(Files::isRegularFile) ?: onPath ?: converters.maxByOrNull { it.compliancy }?.file

    /** Returns the program for logs of [compliancy], a number in their header; the newest if there are several, null if there is none. */
    internal fun programFor(compliancy: Int?): Path? = named?.takeIf(Files::isRegularFile)
        ?: converters.filter { it.compliancy == compliancy }.maxWithOrNull(BY_VERSION)?.file
        ?: onPath

    private fun folders(): List<Path> {
        val data = when {
            system.startsWith("Windows") -> listOfNotNull(variable("APPDATA")?.let(::pathOf), user.resolve("AppData/Roaming"))
            system.startsWith("Mac") -> listOf(user.resolve("Library/Application Support"))
            else -> listOfNotNull(variable("XDG_CONFIG_HOME")?.let(::pathOf), user.resolve(".config"))
        }
        val installed = when {
            system.startsWith("Windows") -> listOfNotNull(
                variable("LOCALAPPDATA")?.let(::pathOf)?.resolve("Programs"),
                variable("PROGRAMFILES")?.let(::pathOf),
                pathOf("C:\\Users\\Public\\wpilib"),
            )

            system.startsWith("Mac") -> listOf(Path.of("/Applications"), user.resolve("Applications"), user.resolve("wpilib"))

            else -> listOf(Path.of("/opt"), user.resolve("wpilib"))
        }
        val ownData = data.distinct().flatMap { within(it) }.map { it.resolve(NAME) }
        // WPILib has a folder for each year.
        val beside = installed.flatMap { within(it) + entriesOf(it).filter(::isYear).flatMap(::within) }
            .flatMap { app -> listOf("resources", "Contents/Resources").map(app::resolve) }
            .flatMap { resources -> listOf(resources, resources.resolve("app.asar.unpacked")).map { it.resolve(NAME) } }
            .flatMap { listOf(it) + entriesOf(it).filter(Files::isDirectory) }
        return (listOfNotNull(named?.takeIf(Files::isDirectory)) + ownData + beside).distinct()
    }

    /** Returns the folders in [folder] that are AdvantageScope's. */
    private fun within(folder: Path) = entriesOf(folder).filter { it.name.startsWith(VIEWER, ignoreCase = true) }

    private fun isYear(folder: Path) = folder.name.length == 4 && folder.name.all(Char::isDigit)

    private fun convertersIn(folder: Path): List<Converter> = entriesOf(folder).mapNotNull { file ->
        val match = CONVERTER.matchEntire(file.name)?.takeIf { Files.isRegularFile(file) && Files.isExecutable(file) }
        match?.let { Converter(file, it.groupValues[1].split('.').map { part -> part.toIntOrNull() ?: 0 }, it.groupValues[2].toInt()) }
    }

    private fun entriesOf(folder: Path): List<Path> = try {
        if (Files.isDirectory(folder)) folder.listDirectoryEntries().sorted() else emptyList()
    } catch (_: IOException) {
        emptyList()
    }

    private fun pathOf(text: String): Path? = try {
        Path.of(text)
    } catch (_: InvalidPathException) {
        null
    }

    public companion object {
        /** The environment variable that names CTRE's program, or a folder with several. */
        public const val SETTING: String = "BADLOG_OWLET"
        private const val NAME = "owlet"
        private const val VIEWER = "AdvantageScope"

        /** Such as `owlet-25.1.0-C12`, the last number being the compliancy. */
        private val CONVERTER = Regex("owlet-([0-9.]+)-C(\\d{1,3})(?:\\.exe)?", RegexOption.IGNORE_CASE)

        private val BY_VERSION = Comparator<Converter> { one, other ->
            one.version.indices.union(other.version.indices).sorted()
                .firstNotNullOfOrNull { i ->
                    compareValues(one.version.getOrElse(i) { 0 }, other.version.getOrElse(i) { 0 }).takeIf {
                        it !=
                            0
                    }
                }
                ?: 0
        }
    }
}
