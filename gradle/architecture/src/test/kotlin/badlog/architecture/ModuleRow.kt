package badlog.architecture

import java.io.File

private val NAME = Regex("`([^`]+)`")

/**
 * A row of the table of modules in `docs/architecture.md`.
 *
 * @property module its folder; those in `libraries/` go without it.
 * @property packageName what the names of its packages begin with; empty for a module without packages.
 * @property mayUse the modules that its code may use.
 * @property testsMayUse those that only its tests may use.
 */
internal class ModuleRow(val module: String, val packageName: String, val mayUse: List<String>, val testsMayUse: List<String>)

/** The rows of the one table of [file] whose first heading is “module”. */
internal fun moduleTable(file: File): List<ModuleRow> = file.readLines()
    .dropWhile { !it.startsWith("| module |") }
    .drop(2)
    .takeWhile { it.startsWith('|') }
    .map { line ->
        val cells = line.removeSurrounding("|").split('|').map { cell -> NAME.findAll(cell).map { it.groupValues[1] }.toList() }
        check(cells.size == 5) { "${file.name} has a table of modules with five columns; this row has ${cells.size}: $line" }
        ModuleRow(cells[0].single(), cells[1].singleOrNull().orEmpty(), cells[3], cells[4])
    }
