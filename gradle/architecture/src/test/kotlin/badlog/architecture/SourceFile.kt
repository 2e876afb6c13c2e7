package badlog.architecture

import java.io.File

private val PACKAGE = Regex("""(?m)^package ([\w.]+)""")
private val IMPORT = Regex("""(?m)^import (?:static )?([\w.]+)""")

/** A declaration at the left margin; its name follows modifiers, type parameters and receiver. */
private val DECLARATION = Regex(
    """(?m)^(?:(?:public|internal|const|inline|data|value|sealed|abstract|open|enum|annotation|suspend|operator|infix|tailrec|final|lateinit) )*""" +
        """(?:class|interface|object|fun(?: interface)?|val|var|typealias) (?:<[^>]*> )?(?:[\w<>?*, ]+\.)?(\w+)""",
)

/**
 * A source file of the project.
 *
 * @property path its path, relative to the project's folder.
 * @property module the folder of its module, without `libraries/`.
 * @property sourceSet the folder under `src`, as in `jsMain`.
 * @property packageName its package, empty if it has none.
 * @property imports the full names that it imports; the name of a star import ends before the star.
 * @property declared the full names of its top-level declarations.
 */
internal class SourceFile(
    val path: String,
    val module: String,
    val sourceSet: String,
    val packageName: String,
    val imports: List<String>,
    val declared: List<String>,
) {
    val isTest: Boolean get() = "test" in sourceSet.lowercase()
}

/** Returns all Kotlin and Java files under [root], except those made by builds. */
internal fun sourcesUnder(root: File): List<SourceFile> = root.walk()
    .onEnter { it == root || (it.name !in setOf("build", "node_modules") && !it.name.startsWith('.')) }
    .filter { it.extension == "kt" || it.extension == "java" }
    .mapNotNull { sourceOf(it, it.relativeTo(root).invariantSeparatorsPath) }
    .sortedBy { it.path }
    .toList()

private fun sourceOf(file: File, path: String): SourceFile? {
    val folders = path.split('/')
    val src = folders.indexOf("src")
    if (src < 1) return null
    // Block comments of a Kotlin file may show imports, too, but never at the left margin.
    val text = file.readText()
    val packageName = PACKAGE.find(text)?.groupValues?.get(1).orEmpty()
    return SourceFile(
        path = path,
        module = folders.take(src).joinToString("/").removePrefix("libraries/"),
        sourceSet = folders[src + 1],
        packageName = packageName,
        imports = IMPORT.findAll(text).map { it.groupValues[1].removeSuffix(".") }.toList(),
        declared = DECLARATION.findAll(text).map { "$packageName.${it.groupValues[1]}" }.toList(),
    )
}
