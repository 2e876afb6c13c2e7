package badlog.architecture

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import java.io.File

private val ROOT = File("../..").canonicalFile

/** Longer than this, it is a guide, and belongs to the guides. */
private const val MAX_LINES = 15

private val CODE = Regex("`([^`]+)`")

/** A name of Kotlin with small and capital letters: constants and packages have other names. */
private val NAME = Regex("""\b(?=\w*[a-z])(?=\w*[A-Z])[A-Za-z]\w*""")

/** The modules that have no guide of their own, but a folder of build scripts around them. */
private fun ModuleRow.isOfBuild() = module.startsWith("gradle/")

class ModuleReadmeSpec : FunSpec({
    val sources = sourcesUnder(ROOT)
    val table = moduleTable(File(ROOT, "docs/architecture.md"))
    val readmes = table.filterNot { it.isOfBuild() || it.module == "samples" }
        .associateWith { row -> listOf("libraries/${row.module}", row.module).map { File(ROOT, "$it/README.md") }.firstOrNull { it.exists() } }

    test("each module has a README of a few lines") {
        readmes.filterValues { it == null || it.readLines().size > MAX_LINES }.keys.map { it.module }.shouldBeEmpty()
    }

    test("the types that a module's README names exist there, or in a module that it may use") {
        val named = readmes.flatMap { (row, file) ->
            val known = sources.filter { it.module == row.module || it.module in row.mayUse }
                .flatMapTo(HashSet()) { source -> source.declared.map { it.substringAfterLast('.') } + File(source.path).nameWithoutExtension }
            CODE.findAll(file?.readText().orEmpty()).flatMap { NAME.findAll(it.groupValues[1]) }.map { it.value }
                .map { name -> "${row.module}: $name" to (name in known) }.toList()
        }
        named.size shouldBeGreaterThan 50
        named.filterNot { it.second }.map { it.first }.shouldBeEmpty()
    }
})
