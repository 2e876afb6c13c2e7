package badlog.release

import java.io.File

/**
 * A third-party library in the downloads.
 *
 * @property group its group on Maven Central, such as `org.slf4j`.
 * @property file its jar.
 * @property description its POM.
 * @property programs the programs that contain it.
 */
internal data class ShippedLibrary(
    val group: String,
    val name: String,
    val version: String,
    val file: File,
    val description: File,
    val programs: List<String>,
) {
    /** The part of the jar's name between version and extension, such as `linux-x86_64`; null if there is none. */
    val classifier: String?
        get() = file.name.takeIf { it.startsWith("$name-$version-") }?.removePrefix("$name-$version-")?.removeSuffix(".jar")
}

/**
 * Returns the libraries in [lines], sorted by name. Each line has the program, `library` or `description`, group, name, version and path,
 * separated by tabs.
 *
 * @throws IllegalArgumentException if a library has no description.
 */
internal fun shippedLibraries(lines: List<String>): List<ShippedLibrary> {
    val (libraries, descriptions) = lines.filter { it.isNotBlank() }.map { it.split('\t') }.partition { it[KIND] == "library" }
    val descriptionOf = descriptions.associate { it.subList(GROUP, PATH) to File(it[PATH]) }
    return libraries.groupBy { it.subList(GROUP, PATH + 1) }.map { (place, entries) ->
        val (group, name, version, path) = place
        val description =
            requireNotNull(descriptionOf[listOf(group, name, version)]) {
                "$group:$name:$version has no POM; see gradle/release/build.gradle."
            }
        ShippedLibrary(group, name, version, File(path), description, entries.map { it.first() }.distinct().sorted())
    }.sortedWith(compareBy({ it.group }, { it.name }, { it.version }, { it.file.name }))
}

private const val KIND = 1
private const val GROUP = 2
private const val PATH = 5
