package badlog.core.conformance

import java.io.File

/** Every case of the corpus. */
internal val CONFORMANCE_CASES: List<ConformanceCase> =
    ORDINARY_CASES + CELL_CASES + HEADER_CASES + CUT_CASES + TORN_CASES + HOLE_CASES + ATTRIBUTE_CASES

/** The files of the corpus by name: `name.bag` and `name.json` for each case. */
internal fun conformanceFiles(): Map<String, ByteArray> = CONFORMANCE_CASES.flatMap { case ->
    listOf(
        "${case.name}.bag" to case.bytes,
        "${case.name}.json" to expectationJson(case.why, case.expected).encodeToByteArray(),
    )
}.toMap()

/** Returns whether [name] belongs to a file that [conformanceFiles] returns, or once returned. */
internal fun isConformanceFile(name: String): Boolean = name.endsWith(".bag") || name.endsWith(".json")

/** Writes the corpus into the folder in the only argument. Removes the files of cases that no longer exist. */
public fun main(arguments: Array<String>) {
    val folder = File(arguments.single())
    val files = conformanceFiles()
    folder.mkdirs()
    folder.listFiles().orEmpty().filter { isConformanceFile(it.name) && it.name !in files }.forEach(File::delete)
    for ((name, bytes) in files) folder.resolve(name).writeBytes(bytes)
    folder.resolve(NUMBER_CORPUS).apply { parentFile.mkdirs() }.writeText(numberCorpus())
}
