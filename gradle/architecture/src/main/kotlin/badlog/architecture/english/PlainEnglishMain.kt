package badlog.architecture.english

import java.io.File
import kotlin.system.exitProcess

/**
 * Counts the phrases in comments and guides, and compares the numbers with the ratchet or lowers it. Arguments: the project's folder, the
 * ratchet's file, the file for the list of all places, `check` or `lower`, then the folders of the modules.
 */
internal fun main(arguments: Array<String>) {
    val (root, ratchetFile, report) = arguments.map(::File)
    val modules = placesByModule(root, arguments.drop(FIXED))
    val counts = modules.mapValues { (_, files) -> files.sumOf { it.places.size } }
    report.writeText(reportOf(modules))
    val ratchet = if (ratchetFile.exists()) Ratchet.of(ratchetFile.readText()) else Ratchet(emptyMap())
    if (arguments[FIXED - 1] == "lower") {
        ratchetFile.writeText(ratchet.loweredTo(counts).text())
    } else {
        val complaints = ratchet.exceededBy(counts).map { (module, count) ->
            "$module has more translated phrases than accepted: $count instead of ${ratchet.accepted[module] ?: 0}."
        }
        if (complaints.isEmpty()) return
        System.err.println(complaints.joinToString("\n") + "\nRewrite the new ones; $report lists all of them.")
        exitProcess(1)
    }
}

/** Returns a line for each place in [modules]: file, line, phrase and advice. */
internal fun reportOf(modules: Map<String, List<FilePlaces>>): String = modules.values.flatten().flatMap { file ->
    file.places.map { "${file.path}:${it.line}: “${it.text}”; ${it.phrase.instead}.\n" }
}.joinToString("")

private const val FIXED = 4
