package badlog.architecture.english

import java.io.File

/** The phrases found in a file. Its [path] is relative to the project's folder. */
internal class FilePlaces(val path: String, val places: List<Place>)

/**
 * Returns the files under [root] that contain English, by module. A module is the longest of [modules] that contains the file; files
 * elsewhere belong to their top folder, or to `.`.
 */
internal fun placesByModule(root: File, modules: List<String>): Map<String, List<FilePlaces>> = root.walk()
    .onEnter { it == root || (it.name !in SKIPPED_FOLDERS && !it.name.startsWith('.')) }
    .filter { it.isFile && it.extension in EXTENSIONS }
    .map { file -> file.relativeTo(root).invariantSeparatorsPath.let { FilePlaces(it, placesIn(it, file.readText())) } }
    .sortedBy { it.path }
    .groupBy { moduleOf(it.path, modules) }

private fun moduleOf(path: String, modules: List<String>): String =
    modules.filter { path.startsWith("$it/") }.maxByOrNull { it.length } ?: path.substringBefore('/', ".")

private val SKIPPED_FOLDERS = setOf("build", "node_modules")
private val EXTENSIONS = setOf("kt", "kts", "java", "gradle", "cpp", "h", "py", "md")
