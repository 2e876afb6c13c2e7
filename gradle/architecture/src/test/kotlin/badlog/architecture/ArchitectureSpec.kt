package badlog.architecture

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.File

private val ROOT = File("../..").canonicalFile
private val SOURCES = sourcesUnder(ROOT)
private val TABLE = moduleTable(File(ROOT, "docs/architecture.md"))

private val MODULES_OF_PACKAGES = SOURCES.filter { !it.isTest }.groupBy({ it.packageName }, { it.module }).mapValues { it.value.toSet() }

/** The packages that `libraries/season/build.gradle` needs only for compiling. */
private val LOADED_BY_PROGRAM = listOf("badlog.charts", "badlog.cli", "badlog.report")

private val FRONT_ENDS = setOf("desktop-viewer", "html-export/page")

/** The files with the state before the first action. */
private val FIRST_STATES = setOf("StateVariable.kt", "PageStore.kt")

/** What makes or changes a place, a board or the state. */
private val CHANGES_OF_STATE = listOf(
    Regex("""(?<![\w.])(ViewerState|Viewport|BoardHistory|FindingsState)\("""),
    Regex("""\b(state|place|viewport|cursors|findings|following|history)\.copy\((place|board|findings|following|range|cursors|selection|visited|visible|full|pinned|second|hover) ="""),
    Regex("""(?<!fun )\bBoard\(\)\.with|\.(withGraphs?|withLines?|withLinesInLast|withToggled|withOwnToggled|withoutLine|withoutSignal|withXy)\("""),
    Regex("""\.(withSwappedAxes|withOrigin|withPlane|withYRange|withSharedY|withLineHidden|movedBefore|resized|renamed)\("""),
)

class ArchitectureSpec : FunSpec({
    test("the sources of robot, page, window and benchmarks are read") {
        SOURCES.map { it.sourceSet }.toSet() shouldContainAll listOf("main", "commonMain", "jvmMain", "jsMain", "test", "commonTest", "benchmark")
        SOURCES.sumOf { it.imports.size } shouldBeGreaterThan 3_000
    }

    test("docs/architecture.md lists every module, and no other") {
        TABLE.map { it.module }.toSet() shouldBe SOURCES.map { it.module }.toSet()
    }

    test("the uses that docs/architecture.md allows between modules form no cycle") {
        circular(TABLE.flatMapTo(HashSet()) { row -> row.mayUse.map { Arrow(row.module, it) } }).shouldBeEmpty()
    }

    test("modules use each other as docs/architecture.md says they may") {
        SOURCES.flatMap { file ->
            val allowed = TABLE.filter { it.module == file.module }
                .flatMap { if (file.isTest) it.mayUse + it.testsMayUse else it.mayUse } + file.module
            file.imports.mapNotNull { import ->
                val modules = packageOf(import, MODULES_OF_PACKAGES.keys)?.let(MODULES_OF_PACKAGES::getValue).orEmpty()
                if (modules.isEmpty() || modules.any { it in allowed }) null else "${file.path}: $import, of ${modules.joinToString()}"
            }
        }.shouldBeEmpty()
    }

    test("only the commands of season use the program that loads them, because Spark runs without it") {
        SOURCES.filter { it.module == "season" && !it.isTest && it.packageName != "badlog.season.command" }
            .flatMap { file -> file.imports.filter { name -> LOADED_BY_PROGRAM.any { name.startsWith("$it.") } }.map { "${file.path}: $it" } }
            .shouldBeEmpty()
    }

    // The compiler forbids other transitions: these are internal to the viewer.
    test("page and window read the state of the viewer and send actions; they make and change no part of it") {
        SOURCES.filter { it.module in FRONT_ENDS && !it.isTest && it.sourceSet != "benchmark" && it.path.substringAfterLast('/') !in FIRST_STATES }
            .flatMap { file ->
                File(ROOT, file.path).readLines().filter { line -> !line.startsWith("import ") && CHANGES_OF_STATE.any { it in line } }
                    .map { "${file.path}: ${it.trim()}" }
            }.shouldBeEmpty()
    }

    test("a package is in one module") {
        MODULES_OF_PACKAGES.filter { it.key.isNotEmpty() && it.value.size > 1 }.keys.shouldBeEmpty()
    }

    // Robots in tests have the package of a team's program.
    test("the packages of a module begin with the name that docs/architecture.md gives them") {
        SOURCES.filter { !it.isTest }.mapNotNull { file ->
            val name = TABLE.single { it.module == file.module }.packageName
            if ("${file.packageName}.".startsWith("$name.") || (name.isEmpty() && file.packageName.isEmpty())) null else "${file.path}: ${file.packageName}"
        }.shouldBeEmpty()
    }

    test("packages form no cycle, in code or in shared test fixtures") {
        val code = packageArrows(SOURCES.filter { !it.isTest }) { packageOf(it, MODULES_OF_PACKAGES.keys) }
        val tests = SOURCES.filter { it.isTest }.groupBy { it.module }.values.map { files ->
            val shared = files.flatMapTo(HashSet()) { it.declared }
            packageArrows(files) { name -> name.substringBeforeLast('.').takeIf { name in shared } }
        }
        val circles = circular(code).map { "$it" } + tests.flatMap { circular(it) }.map { "$it, tests" }
        circles.shouldBeEmpty()
    }
})
