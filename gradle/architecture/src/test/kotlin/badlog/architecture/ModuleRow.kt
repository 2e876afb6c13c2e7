package badlog.architecture

import java.io.File

private val NAME = Regex("`([^`]+)`")

/**
 * A row of the table of modules in `docs/architecture.md`.
 *
 * @property module its folder, without `libraries/`.
 * @property packageName the common beginning of its packages' names; empty for a module without packages.
 * @property mayUse the modules that its code may use.
 * @property testsMayUse the modules that only its tests may use.
 */
internal class ModuleRow(val module: String, val packageName: String, val mayUse: List<String>, val testsMayUse: List<String>)

/** Returns the rows of the table in [file] with “module” as its first heading. */
internal fun moduleTable(file: File): List<ModuleRow> = file.readLines()
    .dropWhile { !it.startsWith("| module |") }
    .drop(2)
    .takeWhile { it.startsWith('|') }
    .map { line ->
        val cells = line.removeSurrounding("|").split('|').map { cell -> NAME.findAll(cell).map { it.groupValues[1] }.toList() }
        check(cells.size == 5) { "${file.name} has a table of modules with five columns; this row has ${cells.size}: $line" }
        ModuleRow(cells[0].single(), cells[1].singleOrNull().orEmpty(), cells[3], cells[4])
    }
